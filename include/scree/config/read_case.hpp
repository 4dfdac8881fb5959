/// From PETSc's options database (case file and command line) to a validated case, and the options as text.
#pragma once

#include <string>

#include "scree/config/case.hpp"
#include "scree/config/input_error.hpp"

namespace scree {

/// The case described by PETSc's global options database; the same on all ranks.
/// Throws InputError at the first unknown key, wrong value or impossible combination.
/// Case::remarks holds one line for each key that this scene does not use.
Case read_case();

/// Every option: key, default, unit, range or choices, text with equation number; for `scree -help`.
std::string help_text();

/// The same as a Markdown table, for `scree -print_options` and the README.
std::string option_table_markdown();

}  // namespace scree

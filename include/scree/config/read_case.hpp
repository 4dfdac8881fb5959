/// From what the user gave to a validated case, and the options as text. Knows no PETSc.
#pragma once

#include <string>

#include "scree/config/case.hpp"
#include "scree/config/case_input.hpp"
#include "scree/config/input_error.hpp"

namespace scree {

/// The case described by `input`; the same on all ranks.
/// Throws InputError at the first unknown key, wrong value or impossible combination, with the place of its key.
/// Case::remarks holds one line for each key that this scene does not use, has a former name, or an odd number.
Case read_case(const CaseInput& input, const Catalogue& catalogue = {});

/// Every option: key, default, unit, range or choices, text with equation number; for `scree -help`.
std::string help_text(const Catalogue& catalogue = {});

/// The same as a Markdown table, for `scree -print_options` and the README.
std::string option_table_markdown(const Catalogue& catalogue = {});

/// The same as a JSON schema of case files (draft 2020-12), for `scree -schema` and editors.
std::string json_schema(const Catalogue& catalogue = {});

}  // namespace scree

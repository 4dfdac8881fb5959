/// The files that a case consists of: the one given and those that it is based on.
#pragma once

#include <string>
#include <vector>

namespace scree {

/// `file` and what it names under a top-level key `based_on`, and so on; the base of all first, as PETSc's options
/// database has to take them. Throws InputError for a file that cannot be read and for files that go round in a circle.
std::vector<std::string> case_files(const std::string& file);

}  // namespace scree

/// Whether the fields that a case wants to report exist in its model.
#pragma once

#include "scree/config/case.hpp"
#include "scree/model/model.hpp"

namespace scree {

/// Throws InputError for a probe or line with a field that the model does not have. Makes no grid of the case.
void check_fields(const Case& the_case, const ModelFactory& models);

}  // namespace scree

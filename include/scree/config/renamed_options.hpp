/// Options that got a better name: the former one is understood for one version more, with a remark.
#pragma once

#include <string>

namespace scree {

/// The present name of an option called `key` before; nullptr if it never had another name.
const std::string* present_name(const std::string& key);

}  // namespace scree

/// The one exception of `config`: a wrong key, value or combination in the case.
#pragma once

#include <stdexcept>
#include <string>

namespace scree {

/// what() is one line: key, value, what would be right. Thrown on all ranks alike.
struct InputError : std::runtime_error {
  InputError(const std::string& key_, const std::string& value_, const std::string& expected_)
      : std::runtime_error(key_ + (value_.empty() ? "" : " = '" + value_ + "'") + ": expected " + expected_),
        key(key_),
        value(value_),
        expected(expected_) {}

  std::string key;
  std::string value;  ///< as given, or of the value as understood; empty: not given
  std::string expected;
};

}  // namespace scree

/// The one exception of `config`: a wrong key, value or combination in the case.
#pragma once

#include <stdexcept>
#include <string>

namespace scree {

/// A text fit for an error message of one line: control characters as blanks, of long ones the first `most` bytes.
std::string in_one_line(std::string text, std::size_t most);

/// what() is one line: key, value, what would be right. Thrown on all ranks alike.
struct InputError : std::runtime_error {
  InputError(const std::string& key_, const std::string& value_, const std::string& expected_)
      : std::runtime_error(in_one_line(key_, 150) + (value_.empty() ? "" : " = '" + in_one_line(value_, 150) + "'") +
                           ": expected " + in_one_line(expected_, 600)),
        key(key_),
        value(value_),
        expected(expected_) {}

  std::string key;
  std::string value;  ///< as given, or of the value as understood; empty: not given
  std::string expected;
};

}  // namespace scree

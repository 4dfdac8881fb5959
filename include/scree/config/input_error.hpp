/// The one exception of `config`: a wrong key, value or combination in the case.
#pragma once

#include <stdexcept>
#include <string>

namespace scree {

/// A text fit for an error message of one line: control characters as blanks, of long ones the first `most` bytes.
std::string in_one_line(std::string text, std::size_t most);

/// what() is one line: place, key, value, what would be right. Thrown on all ranks alike.
struct InputError : std::runtime_error {
  InputError(const std::string& key_, const std::string& value_, const std::string& expected_,
             const std::string& place_ = "");

  std::string key;    ///< empty: the error is of a whole file
  std::string value;  ///< as given, or of the value as understood; empty: not given
  std::string expected;
  std::string place;  ///< "file:line" or "file:line:column"; empty: the command line, or nowhere
};

}  // namespace scree

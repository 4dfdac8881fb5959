#include "scree/config/input_error.hpp"

#include <algorithm>

namespace scree {

std::string in_one_line(std::string text, std::size_t most) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  if (text.size() > most) text.replace(most, std::string::npos, "...");
  return text;
}

}  // namespace scree

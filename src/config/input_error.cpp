#include "scree/config/input_error.hpp"

#include <algorithm>

namespace scree {
namespace {

std::string message(const std::string& key, const std::string& value, const std::string& expected,
                    const std::string& place) {
  constexpr std::size_t most = 300;  // of a long path the end
  std::string line =
      place.empty()
          ? ""
          : in_one_line(place.size() > most ? "..." + place.substr(place.size() - most) : place, most + 3) + ": ";
  if (!key.empty())
    line += in_one_line(key, 150) + (value.empty() ? "" : " = '" + in_one_line(value, 150) + "'") + ": ";
  return line + "expected " + in_one_line(expected, 600);
}

}  // namespace

InputError::InputError(const std::string& key_, const std::string& value_, const std::string& expected_,
                       const std::string& place_)
    : std::runtime_error(message(key_, value_, expected_, place_)),
      key(key_),
      value(value_),
      expected(expected_),
      place(place_) {}

std::string in_one_line(std::string text, std::size_t most) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(text.begin(), text.end(), is_control, ' ');
  if (text.size() > most) text.replace(most, std::string::npos, "...");
  return text;
}

}  // namespace scree

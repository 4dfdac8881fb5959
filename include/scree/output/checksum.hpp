/// Checksums against damage, not against intent.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>

namespace scree {

/// One step of the splitmix64 generator: spreads each bit of x over all bits.
inline std::uint64_t spread(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

inline std::string hexadecimal(std::uint64_t number) {
  char text[24];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

/// Of bytes, in their order.
class ByteSum {
 public:
  void add(const char* bytes, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) sum_ = spread(sum_ ^ static_cast<unsigned char>(bytes[k]));
  }
  std::string text() const { return hexadecimal(sum_); }

 private:
  std::uint64_t sum_ = 0;
};

}  // namespace scree

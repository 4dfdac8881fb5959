/// A seal on an HDF5 file: its first bytes, which HDF5 leaves to us (the user block), hold the size of the file and a
/// checksum of all that HDF5 has to interpret. HDF5 does not survive every wrong byte there, so we look first.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace scree {

/// Size of the user block: a power of two from 512 on.
constexpr std::uint64_t seal_size = 2048;

struct ByteRange {
  std::uint64_t begin, length;
};

/// Writes the seal into the user block of `path`. `numbers`, ascending: the places of the datasets' values, which have
/// checksums of their own and may be large. Throws std::runtime_error.
void write_seal(const std::string& path, const std::vector<ByteRange>& numbers);

/// What is wrong with a file that should be sealed: no such file, another kind of file, cut off, wrong bytes; empty:
/// nothing.
std::string seal_complaint(const std::string& path);

}  // namespace scree

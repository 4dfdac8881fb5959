#include "scree/output/seal.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "scree/output/checksum.hpp"

namespace scree {

namespace {

const std::string mark = "Scree seal 1: ";
const std::string hdf5_mark = "\x89HDF\r\n\x1a\n";

/// What the seal says, but for the checksum.
std::string text_of(std::uint64_t size, const std::vector<ByteRange>& numbers) {
  std::ostringstream text;
  text << mark << size << " bytes; numbers at";
  for (const ByteRange& range : numbers) text << ' ' << range.begin << '+' << range.length;
  text << "; ";
  return text.str();
}

/// Of `text` and of all bytes behind the seal but the numbers.
std::string checksum_of(std::istream& file, std::uint64_t size, const std::vector<ByteRange>& numbers,
                        const std::string& text) {
  ByteSum sum;
  sum.add(text.data(), text.size());
  std::uint64_t at = seal_size;
  char bytes[4096];
  const auto add_until = [&](std::uint64_t end) {
    file.seekg(static_cast<std::streamoff>(at));
    while (at < end &&
           file.read(bytes, static_cast<std::streamsize>(std::min<std::uint64_t>(sizeof bytes, end - at)))) {
      sum.add(bytes, static_cast<std::size_t>(file.gcount()));
      at += static_cast<std::uint64_t>(file.gcount());
    }
  };
  for (const ByteRange& range : numbers) {
    add_until(range.begin);
    at = range.begin + range.length;
  }
  add_until(size);
  return file ? sum.text() : "unreadable";
}

/// The ranges that a seal names, if they are ascending and within the file.
bool read_numbers(std::istream& text, std::uint64_t size, std::vector<ByteRange>& numbers) {
  std::string word, end;
  std::uint64_t last = seal_size;
  while (text >> word && word != ";") {
    const bool final = word.back() == ';';
    std::istringstream pair(word);
    ByteRange range;
    char plus;
    if (!(pair >> range.begin >> plus >> range.length) || plus != '+') return false;
    if (range.begin < last || range.begin > size || range.length > size - range.begin) return false;
    last = range.begin + range.length;
    numbers.push_back(range);
    if (final) return true;
  }
  return false;
}

}  // namespace

void write_seal(const std::string& path, const std::vector<ByteRange>& numbers) {
  const std::uint64_t size = std::filesystem::file_size(path);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const std::string text = text_of(size, numbers);
  const std::string seal = text + checksum_of(file, size, numbers, text) + '\n';
  if (seal.size() > seal_size) throw std::runtime_error("too many datasets for a seal");
  file.seekp(0);
  file << seal << std::flush;
  if (!file) throw std::runtime_error(std::strerror(errno));
}

std::string seal_complaint(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return "it cannot be opened";
  std::string block(seal_size, '\0');
  file.read(block.data(), seal_size);
  block.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  if (block.compare(0, mark.size(), mark) != 0)
    return block.compare(0, hdf5_mark.size(), hdf5_mark) == 0 ? "not a checkpoint of Scree, or of an older version"
                                                              : "not an HDF5 file of Scree";
  std::istringstream seal(block.substr(mark.size()));
  std::uint64_t size = 0;
  std::string bytes, at, word, found;
  std::vector<ByteRange> numbers;
  std::error_code error;
  seal >> size;
  if (size != std::filesystem::file_size(path, error) || size < seal_size) return "truncated, or its size is damaged";
  seal >> bytes >> word >> at;
  if (!read_numbers(seal, size, numbers) || !(seal >> found)) return "damaged";
  const std::string text = text_of(size, numbers);
  const bool same = block.compare(0, text.size(), text) == 0 && checksum_of(file, size, numbers, text) == found;
  return same ? "" : "damaged: its checksum differs";
}

}  // namespace scree

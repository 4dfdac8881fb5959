#include "scree/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>

namespace scree {

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

[[noreturn]] void fail(const std::string& what, const std::string& path) {
  throw std::runtime_error("cannot " + what + " '" + path + "': " + std::strerror(errno));
}

bool flush_to_disk(const std::string& path, int flags) {
  const int descriptor = open(path.c_str(), flags);
  if (descriptor < 0) return false;
  // Directories and some file systems cannot be flushed; that is no loss of data we could do anything about.
  const bool ok = fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS;
  return (close(descriptor) == 0) && ok;
}

}  // namespace

std::string temporary_name(const std::string& path) { return path + ".part"; }

void move_into_place(const std::string& temporary, const std::string& path) {
  if (!flush_to_disk(temporary, O_RDONLY)) fail("flush", temporary);
  if (std::rename(temporary.c_str(), path.c_str()) != 0) fail("replace", path);
  const std::string parent = std::filesystem::path(path).parent_path().string();
  flush_to_disk(parent.empty() ? "." : parent, O_RDONLY | O_DIRECTORY);
}

void write_text_atomically(const std::string& path, const std::string& text) {
  const std::string temporary = temporary_name(path);
  std::unique_ptr<std::FILE, Close> file(std::fopen(temporary.c_str(), "w"));
  if (!file) fail("write", temporary);
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  if (!written || std::fflush(file.get()) != 0) {
    const int code = errno;
    std::remove(temporary.c_str());
    errno = code;
    fail("write", path);
  }
  file.reset();
  move_into_place(temporary, path);
}

}  // namespace scree

#include "scree/output/directory.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <vector>

#include "scree/output/atomic_file.hpp"
#include "scree/output/errors.hpp"

namespace scree {

namespace {

namespace fs = std::filesystem;

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Files that a run was writing when it was killed.
std::vector<fs::path> leftovers(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const fs::path& place :
       {directory, directory / "fields", directory / "checkpoints", directory / "lines", directory / "walls"}) {
    if (!fs::is_directory(place)) continue;
    for (const auto& entry : fs::directory_iterator(place)) {
      const std::string name = entry.path().filename().string();
      const bool ours = place != directory || name == "case.yaml.part" || name == "monitor.csv.part" ||
                        name == "summary.json.part" || name == "fields.xdmf.part";
      if (ours && ends_with(name, temporary_name(""))) files.push_back(entry.path());
    }
  }
  return files;
}

/// Files that a run has written into a directory; all others are left alone.
std::vector<fs::path> files_of_run(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const char* name : {"monitor.csv", "summary.json", "fields.xdmf"}) {
    if (fs::exists(directory / name)) files.push_back(directory / name);
  }
  for (const char* name : {"fields", "checkpoints", "lines", "walls"}) {
    if (!fs::is_directory(directory / name)) continue;
    for (const auto& entry : fs::directory_iterator(directory / name)) {
      const std::string stem = entry.path().stem().string(), extension = entry.path().extension().string();
      const bool csv = extension == ".csv" && is_number(stem.substr(stem.find_last_of('_') + 1));
      if (csv || (extension == ".h5" && is_number(stem))) files.push_back(entry.path());
    }
  }
  return files;
}

bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path a = fs::weakly_canonical(inner), b = fs::weakly_canonical(outer);
  const auto [left, right] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  (void)left;
  return right == b.end() || (right->empty() && std::next(right) == b.end());
}

void create_and_try(const fs::path& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) {
    throw std::runtime_error("cannot create output directory '" + directory.string() + "': " + error.message());
  }
  const std::string trial = (directory / ".scree_write_test").string();
  std::FILE* file = std::fopen(trial.c_str(), "w");
  bool written = file && std::fputs("test\n", file) >= 0;
  int code = errno;
  if (file && std::fclose(file) != 0) {
    written = false;
    code = errno;
  }
  std::remove(trial.c_str());
  if (!written) {
    throw std::runtime_error("cannot write into output directory '" + directory.string() + "': " + std::strerror(code));
  }
}

void prepare(const fs::path& directory, const std::string& restart, bool overwrite) {
  if (fs::exists(directory) && !fs::is_directory(directory)) {
    throw std::runtime_error("output directory '" + directory.string() + "' is a file");
  }
  const bool goes_on = !restart.empty() && fs::exists(directory) && lies_in(restart, directory);
  const std::vector<fs::path> old = files_of_run(directory);
  if (!goes_on && !old.empty() && !overwrite) {
    throw std::runtime_error("output directory '" + directory.string() + "' already holds a run (" +
                             fs::relative(old.front(), directory).string() +
                             "): name another, restart from it, or allow to overwrite it");
  }
  if (old.empty() && fs::exists(directory / "case.yaml")) {
    throw std::runtime_error("output directory '" + directory.string() +
                             "' holds a case.yaml that no run has written: name another");
  }
  create_and_try(directory);
  for (const fs::path& file : leftovers(directory)) fs::remove(file);
  if (goes_on) return;
  for (const fs::path& file : old) fs::remove(file);
}

/// The number at the end of the name of such a file: 12 for fields/000012.h5 and lines/axis_000012.csv; -1: none.
int index_of(const fs::path& file) {
  const std::string stem = file.stem().string(), number = stem.substr(stem.find_last_of('_') + 1);
  return is_number(number) && number.size() < 10 ? std::stoi(number) : -1;
}

}  // namespace

void prepare_directory(MPI_Comm comm, const std::string& path, const std::string& restart, bool overwrite) {
  on_first_rank(comm, [&] { prepare(fs::path(path), restart, overwrite); });
}

void remove_later_outputs(MPI_Comm comm, const std::string& path, int index) {
  on_first_rank(comm, [&] {
    for (const fs::path& file : files_of_run(path)) {
      const std::string place = file.parent_path().filename().string();
      if ((place == "fields" || place == "lines" || place == "walls") && index_of(file) >= index) fs::remove(file);
    }
  });
}

}  // namespace scree

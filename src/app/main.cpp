/// scree CASE.yaml [options]: runs a case. See README.md; `scree -help` lists the options.
#include <petscsys.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scree/app/simulation.hpp"
#include "scree/config/read_case.hpp"

namespace {

bool given(int argc, char** argv, const char* option) {
  for (int k = 1; k < argc; ++k)
    if (std::strcmp(argv[k], option) == 0 || std::strcmp(argv[k], (std::string("-") + option).c_str()) == 0)
      return true;
  return false;
}

/// The case file: the first argument if it is no option; with -restart DIR alone, the effective case of that run.
std::string case_file(int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-') return argv[1];
  for (int k = 1; k + 1 < argc; ++k)
    if (std::strcmp(argv[k], "-restart") == 0) return std::string(argv[k + 1]) + "/case.yaml";
  return "";
}

/// The file that `file` names under a top-level key `based_on`, as a path; empty if there is none.
std::string base_of(const std::string& file) {
  const std::string key = "based_on:";
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const auto first = line.find_first_not_of(" \t\"'", key.size());
    const auto last = line.find_first_of(" \t\"'#\r", first);
    const std::string name = first == std::string::npos ? "" : line.substr(first, last - first);
    return std::filesystem::path(file).parent_path() / name;
  }
  return "";
}

/// `file` and what it is based on, the base of all first.
std::vector<std::string> chain_of(std::string file) {
  constexpr std::size_t longest = 20;  // a circle otherwise
  std::vector<std::string> chain;
  for (; !file.empty() && chain.size() < longest; file = base_of(file)) chain.insert(chain.begin(), file);
  return chain;
}

int complain(const std::string& message) {
  int rank = 0, running = 0;
  MPI_Initialized(&running);
  if (running) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::fprintf(stderr, "scree: %s\n", message.c_str());
  return 1;
}

int run_case() {
  try {
    const scree::Case scene = scree::read_case();
    for (const std::string& remark : scene.remarks) PetscPrintf(PETSC_COMM_WORLD, "%s\n", remark.c_str());
    scree::Simulation(PETSC_COMM_WORLD, scene).run();
    return 0;
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 1 || given(argc, argv, "-help") || given(argc, argv, "-h")) {
    std::printf("usage: mpirun -n RANKS scree CASE.yaml [-option value ...]\n%s", scree::help_text().c_str());
    return 0;
  }
  if (given(argc, argv, "-print_options")) {
    std::printf("%s", scree::option_table_markdown().c_str());
    return 0;
  }
  std::vector<std::string> files = chain_of(case_file(argc, argv));
  const std::string file = files.empty() ? "" : files.front();
  MPI_Init(&argc, &argv);
  int status = 1;
  if (file.empty()) {
    complain("no case file: usage is scree CASE.yaml [-option value ...]");
  } else if (!std::ifstream(file)) {
    complain("case file '" + file + "': expected a readable YAML file");
  } else {
    // PETSc takes an argument that is no option for an unused one: the case file goes in as the third argument instead.
    // Variants come after their base and before the command line, where -options_file_yaml stands.
    std::string option = "-options_file_yaml";
    std::vector<char*> options{argv[0]};
    for (std::size_t k = 1; k < files.size(); ++k) options.insert(options.end(), {option.data(), files[k].data()});
    for (int k = argv[1][0] == '-' ? 1 : 2; k < argc; ++k) options.push_back(argv[k]);
    int count = static_cast<int>(options.size());
    options.push_back(nullptr);
    char** arguments = options.data();
    PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
    const PetscErrorCode code = PetscInitialize(&count, &arguments, file.c_str(), nullptr);
    if (code == 0) {
      PetscPopErrorHandler();
      status = run_case();
      PetscFinalize();
    } else {
      complain("case file '" + file + "': expected valid YAML");
    }
  }
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (!finalized) MPI_Finalize();
  return status;
}

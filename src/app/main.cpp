/// scree CASE.yaml [options]: runs a case. See README.md; `scree -help` lists the options.
#include <petscsys.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "scree/app/problem_setup.hpp"
#include "scree/app/simulation.hpp"
#include "scree/config/case_files.hpp"
#include "scree/config/read_case.hpp"

namespace {

bool given(int argc, char** argv, const char* option) {
  for (int k = 1; k < argc; ++k)
    if (std::strcmp(argv[k], option) == 0 || std::strcmp(argv[k], (std::string("-") + option).c_str()) == 0)
      return true;
  return false;
}

/// The directory of the run that goes on by itself, with -restart DIR and no case file; else empty.
std::string run_to_go_on(int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-') return "";
  for (int k = 1; k + 1 < argc; ++k)
    if (std::strcmp(argv[k], "-restart") == 0) return argv[k + 1];
  return "";
}

/// The case file: the first argument if it is no option; with -restart DIR alone, the effective case of that run.
std::string case_file(int argc, char** argv) {
  if (argc > 1 && argv[1][0] != '-') return argv[1];
  const std::string directory = run_to_go_on(argc, argv);
  return directory.empty() ? "" : directory + "/case.yaml";
}

int complain(const std::string& message) {
  int rank = 0, running = 0;
  MPI_Initialized(&running);
  if (running) MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  if (rank == 0) std::fprintf(stderr, "scree: %s\n", message.c_str());
  return 1;
}

/// Under -check: the case as understood, a YAML file that runs it.
void print_case(const scree::Case& scene) {
  for (const std::string& remark : scene.remarks) PetscPrintf(PETSC_COMM_WORLD, "# %s\n", remark.c_str());
  PetscPrintf(PETSC_COMM_WORLD, "%s", scene.effective_yaml.c_str());
}

/// Options that look like those of PETSc's solvers, but no solver has asked for them: misspelt, or of another solver.
void print_unused(const std::vector<std::string>& petsc_options, scree::Progress& log) {
  for (const std::string& key : petsc_options) {
    bool of_solver = false;  // others may be asked for at the very end
    for (const char* start : {"ts_", "snes_", "ksp_", "pc_", "mat_", "sub_", "mg_", "fieldsplit_", "inner_", "npc_"})
      of_solver = of_solver || key.compare(0, std::strlen(start), start) == 0;
    PetscBool used = PETSC_TRUE;
    if (of_solver && PetscOptionsUsed(nullptr, key.c_str(), &used) == 0 && !used)
      log.remark("%s is not used: PETSc has not asked for it", key.c_str());
  }
}

int run_case() {
  try {
    const scree::Case scene = scree::read_case();
    if (scene.check_only) {
      scree::check_sampling(scene);
      print_case(scene);
      return 0;
    }
    scree::Progress log(PETSC_COMM_WORLD);
    for (const std::string& remark : scene.remarks) log.remark("%s", remark.c_str());
    scree::Simulation(PETSC_COMM_WORLD, scene, log).run();
    print_unused(scene.petsc_options, log);
    return 0;
  } catch (const std::bad_alloc&) {
    return complain("the memory of this machine is too small for the case");
  } catch (const std::exception& error) {
    return complain(error.what());
  }
}

/// PETSc takes an argument that is no option for an unused one: the case file goes in as the third argument instead.
/// Variants come after their base and before the command line, where -options_file_yaml stands.
int run_files(int argc, char** argv, std::vector<std::string> files) {
  std::string option = "-options_file_yaml", output_option = "-output_dir", directory = run_to_go_on(argc, argv);
  std::vector<char*> options{argv[0]};
  for (std::size_t k = 1; k < files.size(); ++k) options.insert(options.end(), {option.data(), files[k].data()});
  // The run may have been moved since its case.yaml was written.
  if (!directory.empty()) options.insert(options.end(), {output_option.data(), directory.data()});
  for (int k = argv[1][0] == '-' ? 1 : 2; k < argc; ++k) options.push_back(argv[k]);
  int count = static_cast<int>(options.size());
  options.push_back(nullptr);
  char** arguments = options.data();
  PetscPushErrorHandler(PetscIgnoreErrorHandler, nullptr);
  if (PetscInitialize(&count, &arguments, files.front().c_str(), nullptr)) {
    std::string names = files.back();
    for (std::size_t k = files.size() - 1; k-- > 0;) names += "' or '" + files[k];
    return complain("case file '" + names + "': expected valid YAML");
  }
  PetscPopErrorHandler();
  const int status = run_case();
  PetscFinalize();
  return status;
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
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files: an error of the write, not the end of the process
  const std::string file = case_file(argc, argv);
  MPI_Init(&argc, &argv);
  int status = 1;
  if (file.empty()) {
    complain("no case file: usage is scree CASE.yaml [-option value ...]");
  } else {
    try {
      status = run_files(argc, argv, scree::case_files(file));
    } catch (const scree::InputError& error) {
      complain(error.what());
    }
  }
  int finalized = 0;
  MPI_Finalized(&finalized);
  if (!finalized) MPI_Finalize();
  return status;
}

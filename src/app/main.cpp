/// scree CASE.yaml [options]: runs a case. See README.md; `scree -help` lists the options.
#include <petscsys.h>

#include <csignal>
#include <cstdio>
#include <new>
#include <string>

#include "scree/app/check_fields.hpp"
#include "scree/app/petsc_session.hpp"
#include "scree/app/simulation.hpp"
#include "scree/config/command_line.hpp"
#include "scree/config/read_case.hpp"

namespace {

bool on_first_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == 0;
}

int complain(const std::string& message) {
  if (on_first_rank()) std::fprintf(stderr, "scree: %s\n", message.c_str());
  return 1;
}

void print(const std::string& text) {
  if (on_first_rank()) std::printf("%s", text.c_str());
}

/// Under -check: the case as understood, a YAML file that runs it.
void print_case(const scree::Case& scene) {
  for (const std::string& remark : scene.remarks) print("# " + remark + "\n");
  print(scene.effective_yaml);
}

void run_case(const char* program, const scree::CaseInput& input) {
  const scree::Case scene = scree::read_case(input);
  const scree::PetscSession petsc(program, scene.petsc_options);
  petsc.check_options();
  scree::check_fields(scene);
  if (scene.check_only) return print_case(scene);
  for (const std::string& remark : scene.remarks) print(remark + "\n");
  scree::Simulation(PETSC_COMM_WORLD, scene).run();
  petsc.print_unused();
}

void run(const char* program, const scree::CommandLine& line) {
  if (line.has("help") || line.has("h") || (line.case_file.empty() && line.options.empty()))
    return print("usage: mpirun -n RANKS scree CASE.yaml [-option value ...]\n" + scree::help_text());
  if (line.has("print_options")) return print(scree::option_table_markdown());
  if (line.has("schema")) return print(scree::json_schema());
  const scree::CaseInput input = scree::case_input(line);
  try {
    run_case(program, input);
  } catch (const scree::InputError& error) {
    throw located(error, input);
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files: an error of the write, not the end of the process
  MPI_Init(&argc, &argv);
  int status = 0;
  try {
    run(argv[0], scree::read_command_line({argv + 1, argv + argc}));
  } catch (const std::bad_alloc&) {
    status = complain("the memory of this machine is too small for the case");
  } catch (const std::exception& error) {
    status = complain(error.what());
  }
  MPI_Finalize();
  return status;
}

#include "scree/app/program.hpp"

#include <mpi.h>

#include <csignal>
#include <cstdio>
#include <new>
#include <string>

#include "scree/app/check_fields.hpp"
#include "scree/app/initial_run.hpp"
#include "scree/app/lone_rank.hpp"
#include "scree/app/petsc_session.hpp"
#include "scree/app/simulation.hpp"
#include "scree/config/command_line.hpp"
#include "scree/config/read_case.hpp"
#include "scree/output/errors.hpp"

namespace scree {

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
void print_case(const Case& the_case) {
  for (const auto* lines : {&the_case.remarks, &the_case.grid_summary})
    for (const std::string& line : *lines) print("# " + line + "\n");
  print(the_case.effective_yaml);
}

const char* const no_memory = "the memory of this machine is too small for the case";

/// Memory that one rank lacks ends all, before the end of PETSc, which would wait for the others.
void simulate(const Case& the_case, const Parts& parts, Progress& log) {
  try {
    Simulation(PETSC_COMM_WORLD, the_case, parts.models, log).run();
  } catch (const std::bad_alloc&) {
    end_all_ranks(no_memory);
    throw;
  }
}

void run_case(const char* program, const CaseInput& input, const Parts& parts) {
  const Case the_case = read_case(input, parts.catalogue);
  const PetscSession petsc(program, the_case.petsc_options);
  petsc.check_options();
  check_fields(the_case, parts.models);
  if (the_case.check_only) {
    check_initial_runs(PETSC_COMM_WORLD, the_case);
    return print_case(the_case);
  }
  Progress log(PETSC_COMM_WORLD);
  for (const std::string& remark : the_case.remarks) log.remark("%s", remark.c_str());
  simulate(the_case, parts, log);
  for (const std::string& key : petsc.unused()) log.remark("%s is not used: PETSc has not asked for it", key.c_str());
}

void run(const char* program, const CommandLine& line, const Parts& parts) {
  if (line.has("help") || line.has("h") || (line.case_file.empty() && line.options.empty()))
    return print("usage: mpirun -n RANKS scree CASE.yaml [-option value ...]\n" + help_text(parts.catalogue));
  if (line.has("print_options")) return print(option_table_markdown(parts.catalogue));
  if (line.has("schema")) return print(json_schema(parts.catalogue));
  const CaseInput input = case_input(line);
  try {
    run_case(program, input, parts);
  } catch (const InputError& error) {
    throw located(error, input);
  }
}

}  // namespace

int run_program(int argc, char** argv, Parts parts) {
  parts.catalogue.further_unknowns = parts.models.further;
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files: an error of the write, not the end of the process
  set_up_lone_rank();
  MPI_Init(&argc, &argv);
  int status = 0;
  try {
    run(argv[0], read_command_line({argv + 1, argv + argc}), parts);
  } catch (const std::bad_alloc&) {
    end_all_ranks(no_memory);
    status = complain(no_memory);
  } catch (const std::exception& error) {
    status = complain(error.what());
  }
  MPI_Finalize();
  return status;
}

}  // namespace scree

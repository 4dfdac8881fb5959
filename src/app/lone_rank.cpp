#include "scree/app/lone_rank.hpp"

#include <cstdlib>
#include <string>

namespace scree {

namespace {

/// Whether mpirun, or a batch system in its place, started this process.
bool has_launcher() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (std::getenv(variable)) return true;
  return false;
}

}  // namespace

void set_up_lone_rank() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  const bool alone = !has_launcher();
  if (alone || (ranks && std::string(ranks) == "1")) setenv("OMPI_MCA_mpi_yield_when_idle", "0", 1);
  if (!alone) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
}

}  // namespace scree

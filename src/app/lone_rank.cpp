#include "scree/app/lone_rank.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

namespace scree {

namespace {

/// Whether mpirun, or a batch system in its place, started this process.
bool has_launcher() {
  for (const char* variable : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK", "SLURM_PROCID"})
    if (std::getenv(variable)) return true;
  return false;
}

/// Processes that start alone share the directories of Open MPI's job 0/1. The last to leave removes both while another
/// may be entering them: that one ends in MPI_Init. What it cannot remove is a directory that is not empty. It may come
/// between here too, until there is something in it.
void keep_session_directory() {
  char host[256] = {};
  if (gethostname(host, sizeof host - 1) != 0) return;
  const std::string node = std::string(host).substr(0, std::string(host).find('.'));
  std::error_code ignored;
  const std::filesystem::path top =
      std::filesystem::temp_directory_path(ignored) / ("ompi." + node + "." + std::to_string(geteuid()));
  if (ignored) return;
  const std::filesystem::path kept = top / "jf.0" / "1" / "kept";
  for (int attempt = 0; attempt < 10 && !std::filesystem::exists(kept, ignored); ++attempt)
    std::filesystem::create_directories(kept, ignored);
}

}  // namespace

void set_up_lone_rank() {
  const char* ranks = std::getenv("OMPI_COMM_WORLD_SIZE");
  const bool alone = !has_launcher();
  if (alone || (ranks && std::string(ranks) == "1")) setenv("OMPI_MCA_mpi_yield_when_idle", "0", 1);
  if (!alone) return;
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_pml", "ob1", 0);
  keep_session_directory();
}

}  // namespace scree

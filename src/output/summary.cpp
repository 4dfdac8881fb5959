#include "scree/output/summary.hpp"

#include <nlohmann/json.hpp>

#include "scree/output/atomic_file.hpp"
#include "scree/output/errors.hpp"

namespace scree {

void write_summary(MPI_Comm comm, const std::string& path, const Summary& summary) {
  on_first_rank(comm, [&] { write_text_atomically(path, summary.dump(2) + '\n'); });
}

}  // namespace scree

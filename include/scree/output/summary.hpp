/// summary.json: how a run ended.
#pragma once

#include <petscsys.h>

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace scree {

/// Keys stay in the order in which they are set: summary["steps"] = 12; summary["seconds"]["total"] = 3.4;
/// Who fills one includes <nlohmann/json.hpp>.
using Summary = nlohmann::ordered_json;

/// Collective. Writes rank 0's summary to `path`, whole or not at all; NaN and infinity become null.
/// Throws std::runtime_error on all ranks.
void write_summary(MPI_Comm comm, const std::string& path, const Summary& summary);

}  // namespace scree

/// The output directory of a run: created, checked to be writable, never mixed with another run.
#pragma once

#include <petscsys.h>

#include <string>

namespace scree {

/// Collective. Makes `path` (and parents) ready for a run.
/// A directory that holds a run (monitor.csv, summary.json, fields.xdmf or checkpoints) is refused, unless `restart`
/// (a directory or checkpoint file, empty: none) lies in it, or `overwrite`, which removes the files of the old run.
/// A case.yaml without a run beside it is somebody's case and always refused.
/// Throws std::runtime_error of one line on all ranks; nothing has been changed or removed then.
void prepare_directory(MPI_Comm comm, const std::string& path, const std::string& restart, bool overwrite);

/// Collective. Removes fields, lines and walls of `index` and later from the output directory `path`.
/// Throws std::runtime_error of one line on all ranks.
void remove_later_outputs(MPI_Comm comm, const std::string& path, int index);

}  // namespace scree

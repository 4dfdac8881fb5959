#include "scree/output/errors.hpp"

#include <cstdio>
#include <stdexcept>

namespace scree {

namespace {

std::string broadcast_from(MPI_Comm comm, int root, std::string text) {
  unsigned long length = text.size();
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG, root, comm);
  text.resize(length);
  MPI_Bcast(text.data(), static_cast<int>(length), MPI_CHAR, root, comm);
  return text;
}

}  // namespace

void agree(MPI_Comm comm, bool ok, const std::string& message) {
  int rank = 0, ranks = 1;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  const int mine = ok ? ranks : rank;
  int first = ranks;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first < ranks) throw std::runtime_error(broadcast_from(comm, first, message));
}

void on_first_rank(MPI_Comm comm, const std::function<void()>& work) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  std::string message;
  bool ok = true;
  if (rank == 0) {
    try {
      work();
    } catch (const std::exception& error) {
      message = error.what();
      ok = false;
    }
  }
  agree(comm, ok, message);
}

std::string broadcast(MPI_Comm comm, std::string text) { return broadcast_from(comm, 0, std::move(text)); }

void end_all_ranks(const char* message) {
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (ranks == 1) return;
  std::fprintf(stderr, "scree: %s\n", message);
  MPI_Abort(MPI_COMM_WORLD, 1);
}

void check_petsc(PetscErrorCode code, const char* doing) {
  if (code == 0) return;
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  const std::string message = std::string(doing) + ": " + (text ? text : "PETSc error " + std::to_string(code));
  end_all_ranks(message.c_str());
  throw std::runtime_error(message);
}

}  // namespace scree

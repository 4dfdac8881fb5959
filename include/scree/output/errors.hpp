/// Errors of the room `output`: one std::runtime_error of one line, thrown on all ranks alike.
#pragma once

#include <petscsys.h>

#include <functional>
#include <string>

namespace scree {

/// Collective. Throws std::runtime_error(message of the lowest rank with ok == false) on all ranks if there is one.
void agree(MPI_Comm comm, bool ok, const std::string& message);

/// Collective. Runs `work` on rank 0 alone; what it throws is thrown on all ranks as std::runtime_error.
void on_first_rank(MPI_Comm comm, const std::function<void()>& work);

/// Collective. Text of rank 0, on all ranks.
std::string broadcast(MPI_Comm comm, std::string text);

/// For what a rank may meet alone, such as memory that is too small: the others would wait for it in the next
/// collective call, or in one of a destructor. Where there are others, prints "scree: <message>" and ends all ranks
/// with exit code 1; else returns.
void end_all_ranks(const char* message);

/// If a PETSc call failed: end_all_ranks, or on one rank std::runtime_error, of "<doing>: <PETSc's text of the code>".
void check_petsc(PetscErrorCode code, const char* doing);

}  // namespace scree

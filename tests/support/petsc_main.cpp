/// Runs the tests of an executable inside MPI and PETSc, on any number of ranks; it fails if they fail on any rank.
#include <gtest/gtest.h>
#include <petscsys.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (PetscInitialize(&argc, &argv, nullptr, nullptr) != 0) return 1;
  int mine = RUN_ALL_TESTS(), all = 0;
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MAX, PETSC_COMM_WORLD);
  return PetscFinalize() == 0 ? all : 1;
}

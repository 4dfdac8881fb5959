/// PETSc around the tests of `config`, which read its options database.
#include <gtest/gtest.h>
#include <petscsys.h>

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (PetscInitialize(&argc, &argv, nullptr, nullptr)) return 1;
  const int result = RUN_ALL_TESTS();
  if (PetscOptionsClear(nullptr) || PetscFinalize()) return 1;
  return result;
}

/// kernels_benchmark CASES [options of Google Benchmark]: CASES is the folder cases/ of the sources; bin_3d.yaml is
/// found from there.
#include <benchmark/benchmark.h>
#include <petscsys.h>

#include <cstdio>
#include <exception>

#include "benchmarks.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: kernels_benchmark CASES [--benchmark_filter=REGEX ...]\n");
    return 1;
  }
  if (PetscInitializeNoArguments() != 0) return 1;
  scree::benchmarks::add_machine();
  scree::benchmarks::add_closures();
  scree::benchmarks::add_assembly(argv[1]);
  scree::benchmarks::add_preconditioners(argv[1]);
  try {
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kernels_benchmark: %s\n", error.what());
    return 1;
  }
  benchmark::ClearRegisteredBenchmarks();  // they hold PETSc's objects
  benchmark::Shutdown();
  return PetscFinalize() == 0 ? 0 : 1;
}

#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "benchmarks.hpp"

namespace scree::benchmarks {
namespace {

/// McCalpin's triad a = b + s c on arrays of 256 MB, far beyond the caches. Writing `a` reads its cache lines too.
void triad(benchmark::State& state) {
  constexpr std::size_t count = std::size_t{1} << 25;
  std::vector<double> a(count, 0), b(count, 1), c(count, 2);
  double s = 3;
  for (auto _ : state) {
    benchmark::DoNotOptimize(s);
    for (std::size_t i = 0; i < count; ++i) a[i] = b[i] + s * c[i];
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(count) * 3 * 8);
}

/// Independent chains of multiply-adds in registers: as many as hide their latency.
void multiply_add(benchmark::State& state) {
  constexpr int width = 8, chains = 12, rounds = 1000;
  using Vector [[gnu::vector_size(8 * width)]] = double;
  std::array<Vector, chains> x;
  for (auto& v : x) v = Vector{} + 1.0;
  Vector a = Vector{} + 0.999999, b = Vector{} + 1e-6;
  for (auto _ : state) {
    benchmark::DoNotOptimize(a);
    benchmark::DoNotOptimize(b);
    for (int k = 0; k < rounds; ++k)
#pragma GCC unroll 12
      for (int i = 0; i < chains; ++i) x[i] = x[i] * a + b;
  }
  Vector sum = x[0];
  for (int i = 1; i < chains; ++i) sum += x[i];
  benchmark::DoNotOptimize(sum);
  state.counters["flops"] =
      benchmark::Counter(2.0 * width * chains * rounds, benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

void add_machine() {
  benchmark::RegisterBenchmark("machine/triad", triad)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("machine/multiply_add", multiply_add);
}

}  // namespace scree::benchmarks

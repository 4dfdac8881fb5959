#include <benchmark/benchmark.h>

#include "benchmarks.hpp"
#include "scenes.hpp"

namespace scree::benchmarks {
namespace {

/// The sample of a scene on a grid. One is kept: those of fine grids are large.
class Samples {
 public:
  Sample& get(const Scene& scene, int refine) {
    const std::string name = scene.name + std::to_string(refine);
    if (name != name_) {
      kept_.reset();
      kept_ = std::make_unique<Sample>(scene, refine);
      name_ = name;
    }
    return *kept_;
  }

 private:
  std::unique_ptr<Sample> kept_;
  std::string name_;
};

/// What has to be moved to and from memory at least, each number once [bytes a cell].
double least_bytes_residual(const Sample& s) { return 8 * 3 * s.unknowns(); }
double least_bytes_jacobian(const Sample& s) { return 8 * (2 * s.unknowns() + s.entries()); }

void report(benchmark::State& state, const Sample& s, double bytes) {
  using benchmark::Counter;
  state.counters["time_per_cell"] = Counter(s.cells(), Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["cells"] = s.cells();
  state.counters["unknowns"] = s.unknowns();
  state.counters["bytes_per_cell"] = bytes;
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes * s.cells()));
}

}  // namespace

void add_assembly(const std::string& cases) {
  const auto samples = std::make_shared<Samples>();
  for (const Scene& scene : scenes(cases))
    for (const int refine : scene.refined) {
      const std::string name = scene.name + "/" + std::to_string(refine);
      benchmark::RegisterBenchmark(("residual/" + name).c_str(), [=](benchmark::State& state) {
        Sample& s = samples->get(scene, refine);
        for (auto _ : state) s.residual();
        report(state, s, least_bytes_residual(s));
      })->Unit(benchmark::kMillisecond);
      benchmark::RegisterBenchmark(("jacobian/" + name).c_str(), [=](benchmark::State& state) {
        Sample& s = samples->get(scene, refine);
        for (auto _ : state) s.jacobian();
        report(state, s, least_bytes_jacobian(s));
      })->Unit(benchmark::kMillisecond);
    }
}

}  // namespace scree::benchmarks

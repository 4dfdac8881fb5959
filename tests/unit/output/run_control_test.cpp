#include "sample_state.hpp"
#include "scree/output/progress.hpp"
#include "scree/output/stop_request.hpp"
#include "scree/output/summary.hpp"

namespace scree {
namespace {

using test::Scratch;

TEST(StopRequest, ASignalToOneRankStopsAll) {
  StopRequest stop(PETSC_COMM_WORLD);
  EXPECT_FALSE(stop.requested());
  if (test::this_rank() == 0) raise(SIGTERM);
  EXPECT_TRUE(stop.requested());
  EXPECT_EQ(stop.reason(), "SIGTERM");
}

TEST(StopRequest, BudgetRunsOut) {
  StopRequest stop(PETSC_COMM_WORLD, 1e-9);
  EXPECT_TRUE(stop.requested());
  EXPECT_EQ(stop.reason(), "wall-clock budget");
}

TEST(ProgressLine, TellsWhatIsLeft) {
  EXPECT_EQ(progress_line(12, 0.25, 1e-4, 0, 1, 0.01),
            "time 0.25 s  dt 1.00e-04 s  step 12   25.0 %  rate 0.01 s/s  left 0:01:15");
  EXPECT_EQ(progress_line(0, 2, 1e-4, 2, 4, 0), "time 2 s  dt 1.00e-04 s  step 0    0.0 %");
}

TEST(Summary, KeepsTheOrderOfKeys) {
  const Scratch scratch;
  Summary summary;
  summary["steps"] = 12;
  summary["mass_error"] = std::nan("");
  summary["seconds"]["total"] = 1.5;
  write_summary(PETSC_COMM_WORLD, scratch / "summary.json", summary);
  EXPECT_EQ(test::content(scratch / "summary.json"),
            "{\n  \"steps\": 12,\n  \"mass_error\": null,\n  \"seconds\": {\n    \"total\": 1.5\n  }\n}\n");
  test::barrier();
}

}  // namespace
}  // namespace scree

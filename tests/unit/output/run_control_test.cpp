#include <nlohmann/json.hpp>
#include <utility>

#include "sample_state.hpp"
#include "scree/output/output_times.hpp"
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

TEST(ProgressLine, PromisesNothingWhileTheFirstStepsGrow) {
  EXPECT_EQ(progress_line(1, 1e-6, 1e-6, 0, 1, 1e-4), "time 1e-06 s  dt 1.00e-06 s  step 1    0.0 %  rate 0.0001 s/s");
  EXPECT_EQ(progress_line(9, 0.01, 1e-3, 0, 1, 0.01),
            "time 0.01 s  dt 1.00e-03 s  step 9    1.0 %  rate 0.01 s/s  left 0:01:39");
}

/// A terminal of the test, and its clock.
struct Screen {
  std::string text;
  double now = 100;
  LogTarget target(bool terminal) {
    return {[this](const std::string& more) { text += more; }, [this] { return now; }, terminal};
  }
  std::string take() { return std::exchange(text, ""); }
};

std::string line_of(int step, double time, double rate) { return progress_line(step, time, 0.1, 0, 10, rate); }

TEST(Progress, TheLineOfATerminalRenewsItself) {
  Screen screen;
  Progress progress(PETSC_COMM_SELF, screen.target(true));
  progress.begin(0, 10);
  screen.now += 0.5;
  progress.update(1, 0.1, 0.1);
  EXPECT_EQ(screen.take(), '\r' + line_of(1, 0.1, 0.2) + "\033[K");
  screen.now += 0.1;
  progress.update(2, 0.2, 0.1);
  EXPECT_EQ(screen.take(), "") << "too soon to be read";
  screen.now += 0.4;
  progress.update(3, 0.5, 0.1);
  EXPECT_EQ(screen.take(), '\r' + line_of(3, 0.5, 0.5) + "\033[K") << "the rate is that of now";
  progress.finish();
  EXPECT_EQ(screen.take(), "\n");
}

TEST(Progress, RemarksDoNotTearTheLine) {
  Screen screen;
  Progress progress(PETSC_COMM_SELF, screen.target(true));
  progress.remark("before %d of %s", 1, "all");
  EXPECT_EQ(screen.take(), "before 1 of all\n");
  progress.begin(0, 10);
  screen.now += 1;
  progress.update(1, 1, 0.1);
  screen.take();
  progress.remark("100 %%");
  EXPECT_EQ(screen.take(), "\r\033[K100 %\n\r" + line_of(1, 1, 1) + "\033[K");
  progress.finish();
  progress.remark("after");
  EXPECT_EQ(screen.take(), "\nafter\n");
}

TEST(Progress, PlainLinesComeAtIntervals) {
  Screen screen;
  Progress progress(PETSC_COMM_SELF, screen.target(false), 5);
  progress.begin(0, 10);
  for (int step = 1; step <= 10; ++step) {
    screen.now += 1;
    progress.update(step, step, 0.1);
  }
  progress.finish();
  EXPECT_EQ(screen.take(), line_of(1, 1, 1) + '\n' + line_of(6, 6, 1) + '\n' + line_of(10, 10, 1) + '\n');
}

/// Steps of equal length that become ten times as fast: soon so does what is left.
TEST(Progress, TimeLeftIsNotStale) {
  Screen screen;
  Progress progress(PETSC_COMM_SELF, screen.target(true));
  progress.begin(0, 10);
  double time = 0;
  const auto go = [&](double rate, int seconds) {
    for (int second = 0; second < seconds; ++second) {
      screen.now += 1;
      progress.update(1, time += rate, rate);
    }
  };
  go(0.01, 20);
  go(0.1, 20);
  const std::string text = screen.take(), left = text.substr(text.rfind("left ") + 5, 7);
  EXPECT_GT(left, "0:01:15") << "7.8 s at .1 s/s take 0:01:18";
  EXPECT_LT(left, "0:01:25");
}

TEST(Progress, OtherRanksAreSilent) {
  Screen screen;
  Progress progress(PETSC_COMM_WORLD, screen.target(false));
  progress.remark("here");
  EXPECT_EQ(screen.take(), test::this_rank() == 0 ? "here\n" : "");
}

TEST(OutputTimes, AreMultiplesOfTheInterval) {
  OutputTimes times(0.1, 0);
  EXPECT_EQ(times.next(), 0.1);
  EXPECT_FALSE(times.due(0.09));
  EXPECT_TRUE(times.due(0.1));
  times.pass(0.1);
  EXPECT_EQ(times.next(), 0.2);
  times.pass(0.2);
  EXPECT_EQ(times.next(), 0.1 * 3);
  EXPECT_TRUE(times.due(0.3)) << "though 3 * 0.1 is more than 0.3";
  times.pass(0.3);
  EXPECT_EQ(times.next(), 0.4);
  EXPECT_EQ(OutputTimes(0.1, 0.35).next(), 0.4) << "of a restart";
}

TEST(OutputTimes, NoIntervalIsNeverDue) {
  const OutputTimes never(0, 5);
  EXPECT_FALSE(never.due(1e300));
  EXPECT_GT(never.next(), 1e300);
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

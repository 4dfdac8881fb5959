#include "scree/output/monitor.hpp"

#include "sample_state.hpp"

namespace scree {
namespace {

using test::content;
using test::Scratch;

const std::vector<Column> columns{{"time", "s", "reached"}, {"dt", "s", "of the step"}, {"mass", "kg", "of all"}};

TEST(MonitorFile, OneHeaderAndARowAStep) {
  const Scratch scratch;
  MonitorFile monitor(PETSC_COMM_WORLD, scratch / "monitor.csv", columns);
  monitor.append({0.1, 1e-3, 1.0 / 3});
  EXPECT_EQ(content(scratch / "monitor.csv"), "time,dt,mass\n0.1,0.001,0.3333333333\n") << "flushed at once";
  EXPECT_NE(test::message_of([&] { monitor.append({0.2}); }), "");
  test::barrier();
}

TEST(MonitorFile, RestartDropsLaterAndTornRows) {
  const Scratch scratch;
  const double restart = 0.1 + 0.2;  // not the number that 0.3 is read as
  test::put(scratch / "monitor.csv", "time,dt,mass\n0.1,1,7\n0.3,2,8\n0.4,3,9\n0.2,1");
  MonitorFile monitor(PETSC_COMM_WORLD, scratch / "monitor.csv", columns, restart);
  monitor.append({0.5, 4, 10});
  EXPECT_EQ(content(scratch / "monitor.csv"), "time,dt,mass\n0.1,1,7\n0.3,2,8\n0.5,4,10\n");
  EXPECT_FALSE(std::filesystem::exists(scratch / "monitor_000.csv"));
  test::barrier();
}

TEST(MonitorFile, RestartWithOtherColumnsKeepsTheOldFile) {
  const Scratch scratch;
  const std::string old = "time,mass,gone\n0.1,7,1\n";
  test::put(scratch / "monitor.csv", old);
  MonitorFile monitor(PETSC_COMM_WORLD, scratch / "monitor.csv", columns, 1.0);
  EXPECT_EQ(content(scratch / "monitor.csv"), "time,dt,mass\n0.1,nan,7\n");
  EXPECT_EQ(content(scratch / "monitor_000.csv"), old);
  test::barrier();
}

TEST(MonitorFile, NoDirectoryIsAnError) {
  const Scratch scratch;
  const auto open = [&] { MonitorFile(PETSC_COMM_WORLD, scratch / "none/monitor.csv", columns); };
  EXPECT_NE(test::message_of(open).find("cannot write"), std::string::npos);
}

}  // namespace
}  // namespace scree

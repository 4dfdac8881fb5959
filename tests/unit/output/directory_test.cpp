#include "scree/output/directory.hpp"

#include "sample_state.hpp"

namespace scree {
namespace {

using test::message_of;
using test::Scratch;

std::string complaint(const std::string& path, const std::string& restart = "", bool overwrite = false) {
  return message_of([&] { prepare_directory(PETSC_COMM_WORLD, path, restart, overwrite); });
}

TEST(PrepareDirectory, ParentsAreCreated) {
  const Scratch scratch;
  EXPECT_EQ(complaint(scratch / "a/b/c"), "");
  EXPECT_TRUE(std::filesystem::is_directory(scratch / "a/b/c"));
  EXPECT_TRUE(std::filesystem::is_empty(scratch / "a/b/c"));
  test::barrier();
}

TEST(PrepareDirectory, ARunIsNotMixedWithAnother) {
  const Scratch scratch;
  const std::string out = scratch / "out";
  test::put(out + "/monitor.csv", "time\n");
  test::put(out + "/fields/000003.h5", "x");
  test::put(out + "/notes.txt", "mine");
  EXPECT_NE(complaint(out).find("already holds a run (monitor.csv)"), std::string::npos);
  EXPECT_NE(complaint(out, scratch / "elsewhere"), "");
  EXPECT_EQ(complaint(out, out + "/"), "");
  EXPECT_EQ(complaint(out, out + "/checkpoints/00000001.h5"), "");
  EXPECT_TRUE(std::filesystem::exists(out + "/fields/000003.h5"));
  test::barrier();
  EXPECT_EQ(complaint(out, "", true), "");
  EXPECT_FALSE(std::filesystem::exists(out + "/monitor.csv"));
  EXPECT_FALSE(std::filesystem::exists(out + "/fields/000003.h5"));
  EXPECT_TRUE(std::filesystem::exists(out + "/notes.txt"));
  test::barrier();
}

TEST(PrepareDirectory, SomebodysCaseIsNotOverwritten) {
  const Scratch scratch;
  test::put(scratch / "cases/case.yaml", "grid:\n");
  EXPECT_NE(complaint(scratch / "cases", "", true).find("case.yaml"), std::string::npos);
}

TEST(PrepareDirectory, UnusablePlacesAreNamed) {
  const Scratch scratch;
  test::put(scratch / "file", "x");
  EXPECT_NE(complaint(scratch / "file").find("is a file"), std::string::npos);
  EXPECT_NE(complaint(scratch / "file/out").find("cannot create"), std::string::npos);
  EXPECT_NE(complaint("/proc/scree_out").find("cannot create"), std::string::npos);
}

}  // namespace
}  // namespace scree

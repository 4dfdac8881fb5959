#include "scree/output/checkpoint.hpp"

#include <signal.h>
#include <sys/resource.h>

#include <cstring>
#include <limits>
#include <random>

#include "sample_state.hpp"

namespace scree {
namespace {

using test::message_of;
using test::Scene;
using test::Scratch;

/// Bits that a detour over text or float would lose.
double awkward(const Index& node, int component) {
  if (node[0] == 1 && component == 0) return std::numeric_limits<double>::denorm_min();
  if (node[0] == 2 && component == 0) return -0.0;
  return std::sin(Scene::code(node, component)) * 1e-7;
}

void write_step(const Scratch& scratch, const Scene& scene, int step) {
  write_checkpoint(scratch.path(), step, scene.box, scene.dm, scene.fields, {{"state", scene.state}},
                   {{"time", 0.1 * step}}, {});
}

Checkpoint read(const Scratch& scratch, const Scene& scene) {
  return read_checkpoint(scratch.path(), scene.box, scene.dm, scene.fields);
}

bool same_bits(Vec a, Vec b) {
  PetscInt size = 0;
  const PetscScalar *left = nullptr, *right = nullptr;
  check_petsc(VecGetLocalSize(a, &size), "compare");
  check_petsc(VecGetArrayRead(a, &left), "compare");
  check_petsc(VecGetArrayRead(b, &right), "compare");
  const bool same = std::memcmp(left, right, size * sizeof *left) == 0;
  check_petsc(VecRestoreArrayRead(a, &left), "compare");
  check_petsc(VecRestoreArrayRead(b, &right), "compare");
  return same;
}

void change_byte(const std::string& path, const std::string& after, int distance) {
  if (test::this_rank() == 0) {
    std::string bytes = test::content(path);
    const size_t place = bytes.find(after);
    ASSERT_NE(place, std::string::npos);
    bytes[place + distance] ^= 1;
    std::ofstream(path, std::ios::binary) << bytes;
  }
  test::barrier();
}

TEST(Checkpoint, RoundTripIsBitExact) {
  for (int dim = 1; dim <= 3; ++dim) {
    const Scratch scratch;
    const Scene scene(dim, dim == 2);
    Vec rate = nullptr;
    check_petsc(VecDuplicate(scene.state, &rate), "copy");
    scene.fill(rate, awkward);
    const NamedScalars scalars{{"time", 0.1}, {"dt", 1e-300}, {"limit", std::numeric_limits<double>::infinity()}};
    const NamedStrings strings{{"case", "a: \"b\"\n"}, {"empty", ""}};
    write_checkpoint(scratch.path(), 7, scene.box, scene.dm, scene.fields, {{"state", scene.state}, {"rate", rate}},
                     scalars, strings);
    const Checkpoint checkpoint = read(scratch, scene);
    EXPECT_EQ(checkpoint.file, scratch / "checkpoints/00000007.h5");
    EXPECT_EQ(checkpoint.remark, "");
    EXPECT_EQ(checkpoint.scalars, scalars);
    EXPECT_EQ(checkpoint.strings, strings);
    EXPECT_TRUE(same_bits(checkpoint.vector("state"), scene.state));
    EXPECT_TRUE(same_bits(checkpoint.vector("rate"), rate));
    EXPECT_FALSE(checkpoint.has("older_state"));
    check_petsc(VecDestroy(&rate), "copy");
  }
}

/// All ranks write together, then each reads alone.
TEST(Checkpoint, OtherNumberOfRanks) {
  const Scratch scratch;
  const Scene scene(2);
  write_step(scratch, scene, 1);
  DM alone = nullptr;
  check_petsc(DMDACreate2d(PETSC_COMM_SELF, DM_BOUNDARY_NONE, DM_BOUNDARY_NONE, DMDA_STENCIL_STAR, 7, 6, 1, 1, 3, 1,
                           nullptr, nullptr, &alone),
              "grid");
  check_petsc(DMSetUp(alone), "grid");
  {
    const Checkpoint checkpoint = read_checkpoint(scratch.path(), scene.box, alone, scene.fields);
    const PetscScalar* values = nullptr;
    check_petsc(VecGetArrayRead(checkpoint.vector("state"), &values), "values");
    size_t place = 0;
    const NodeBlock all = owned_block(checked_lattice(scene.box, alone));
    for_each_node(all.first, all.count, [&](const Index& node) {
      for (int component = 0; component < 3; ++component) EXPECT_EQ(values[place++], Scene::code(node, component));
    });
    check_petsc(VecRestoreArrayRead(checkpoint.vector("state"), &values), "values");
  }
  check_petsc(DMDestroy(&alone), "grid");
}

TEST(Checkpoint, KeepsTheLastTwo) {
  const Scratch scratch;
  const Scene scene(1);
  for (const int step : {3, 10, 20}) write_step(scratch, scene, step);
  EXPECT_FALSE(std::filesystem::exists(scratch / "checkpoints/00000003.h5"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "checkpoints/00000010.h5"));
  EXPECT_EQ(read(scratch, scene).scalar("time"), 0.1 * 20);
  test::barrier();
  write_step(scratch, scene, 12);  // of a run that went on from 10
  EXPECT_FALSE(std::filesystem::exists(scratch / "checkpoints/00000020.h5"));
  EXPECT_EQ(read(scratch, scene).scalar("time"), 0.1 * 12);
}

TEST(Checkpoint, DamagedOneFallsBackToTheOneBefore) {
  const Scratch scratch;
  const Scene scene(2);
  write_step(scratch, scene, 1);
  write_step(scratch, scene, 2);
  const std::string newest = scratch / "checkpoints/00000002.h5";
  const auto size = std::filesystem::file_size(newest);
  test::barrier();
  if (test::this_rank() == 0) std::filesystem::resize_file(newest, size / 2);
  test::barrier();
  const Checkpoint checkpoint = read(scratch, scene);
  EXPECT_EQ(checkpoint.scalar("time"), 0.1);
  EXPECT_NE(checkpoint.remark.find("00000002.h5' cannot be used: truncated"), std::string::npos) << checkpoint.remark;
  const std::string message = message_of([&] { read_checkpoint(newest, scene.box, scene.dm, scene.fields); });
  EXPECT_NE(message.find("truncated"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

TEST(Checkpoint, OneWrongBitIsRefused) {
  const Scratch scratch;
  const Scene scene(2);
  scene.fill(scene.state, [](const auto& node, int) { return node[0] == 3 ? 0.7320508 : 0.0; });
  write_step(scratch, scene, 1);
  const std::string path = scratch / "checkpoints/00000001.h5";
  const double number = 0.7320508;
  const std::string bytes(reinterpret_cast<const char*>(&number), sizeof number);
  change_byte(path, bytes, 3);
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("checksum of vector state"), std::string::npos);
  write_step(scratch, scene, 1);
  change_byte(path, "\"scalars\":{\"time\":0.1", 20);
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("damaged: its checksum differs"), std::string::npos);
}

/// A file with any bytes changed or missing is refused, or holds what was written (HDF5 does not use all bytes). Other
/// damages with --gtest_random_seed=N.
TEST(Checkpoint, DamageIsNeverBelieved) {
  const Scratch scratch;
  const Scene scene(2);
  scene.fill(scene.state, awkward);
  write_step(scratch, scene, 1);
  const std::string path = scratch / "checkpoints/00000001.h5";
  const std::string sound = test::content(path);
  std::mt19937 random(static_cast<unsigned>(testing::UnitTest::GetInstance()->random_seed()));  // the same on all ranks
  const auto below = [&](size_t limit) { return static_cast<size_t>(random() % limit); };
  for (int k = 0; k < 300; ++k) {
    std::string bytes = sound;
    if (below(10) == 0) bytes.resize(below(bytes.size()));
    for (size_t changes = size_t{1} << below(7); changes > 0 && !bytes.empty(); --changes)
      bytes[below(below(2) ? std::min<size_t>(bytes.size(), 8192) : bytes.size())] ^= static_cast<char>(1 + below(255));
    test::barrier();
    if (test::this_rank() == 0) std::ofstream(path, std::ios::binary) << bytes;
    test::barrier();
    try {
      const Checkpoint checkpoint = read(scratch, scene);
      EXPECT_TRUE(same_bits(checkpoint.vector("state"), scene.state)) << "damage " << k;
      EXPECT_EQ(checkpoint.scalar("time"), 0.1) << "damage " << k;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("cannot be used"), std::string::npos) << error.what();
    }
  }
}

enum class Mood { calm, wild };
struct Owner {
  int steps = 0;
  double length = 0;
  bool fresh = false;
  Mood mood = Mood::calm;
  template <class Visit>
  void each_member(Visit&& visit) {
    visit("steps", steps);
    visit("length", length);
    visit("fresh", fresh);
    visit("mood", mood);
  }
};

TEST(CheckpointMembers, ComeBackByName) {
  const Scratch scratch;
  const Scene scene(1);
  NamedScalars scalars;
  store_members(Owner{7, 0.1, true, Mood::wild}, "own_", scalars);
  EXPECT_EQ(scalars.size(), 4u);
  EXPECT_THROW(store_members(Owner(), "own_", scalars), std::logic_error) << "names used twice";
  write_checkpoint(scratch.path(), 1, scene.box, scene.dm, scene.fields, {{"state", scene.state}}, scalars, {});
  Owner owner;
  restore_members(read(scratch, scene), "own_", owner);
  EXPECT_EQ(owner.steps, 7);
  EXPECT_EQ(owner.length, 0.1);
  EXPECT_TRUE(owner.fresh);
  EXPECT_EQ(owner.mood, Mood::wild);
}

TEST(CheckpointMembers, OfANewerVersionKeepTheirValues) {
  const Scratch scratch;
  const Scene scene(1);
  write_step(scratch, scene, 1);
  Owner owner{7, 0.1, true, Mood::wild};
  restore_members(read(scratch, scene), "own_", owner);
  EXPECT_EQ(owner.steps, 7);
  EXPECT_EQ(owner.mood, Mood::wild);
}

TEST(Checkpoint, NanIsRefused) {
  const Scratch scratch;
  const Scene scene(1);
  scene.fill(scene.state, [](const auto& node, int) { return node[0] == 3 ? std::nan("") : 1.0; });
  write_step(scratch, scene, 1);
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("vector state holds a NaN"), std::string::npos);
}

TEST(Checkpoint, ForeignFilesAreRefused) {
  const Scratch scratch;
  const Scene scene(2);
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("no checkpoint in"), std::string::npos);
  test::put(scratch / "checkpoints/00000001.h5", "not at all");
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("not an HDF5 file"), std::string::npos);
  const std::string nowhere = scratch / "nowhere";
  const auto read_nowhere = [&] { read_checkpoint(nowhere, scene.box, scene.dm, scene.fields); };
  EXPECT_NE(message_of(read_nowhere).find("does not exist"), std::string::npos);
}

TEST(Checkpoint, OtherGridOrFieldsAreRefused) {
  const Scratch scratch;
  Scene scene(2);
  write_step(scratch, scene, 1);
  Box moved = scene.box;
  moved.faces[1][2] += 1e-3;
  const auto read_moved = [&] { read_checkpoint(scratch.path(), moved, scene.dm, scene.fields); };
  EXPECT_NE(message_of(read_moved).find("cell faces along y"), std::string::npos);
  const Scene other(3);
  EXPECT_NE(message_of([&] { read(scratch, other); }).find("dimension"), std::string::npos);
  scene.fields[1].scale *= 2;
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("velocity has another scale"), std::string::npos);
  scene.fields.pop_back();
  EXPECT_NE(message_of([&] { read(scratch, scene); }).find("3 fields, the case 2"), std::string::npos);
}

/// A limit on the size of files stands for a full disk.
TEST(Checkpoint, FullDiskLeavesTheLastOne) {
  const Scratch scratch;
  const Scene scene(2);
  write_step(scratch, scene, 1);
  struct rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  const auto old_handler = signal(SIGXFSZ, SIG_IGN);
  const struct rlimit small = {3000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const std::string message = message_of([&] { write_step(scratch, scene, 2); });
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, old_handler);
  EXPECT_NE(message.find("cannot write"), std::string::npos) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_EQ(read(scratch, scene).scalar("time"), 0.1);
  EXPECT_FALSE(std::filesystem::exists(scratch / "checkpoints/00000002.h5.part"));
  test::barrier();
  write_step(scratch, scene, 2);
  EXPECT_EQ(read(scratch, scene).scalar("time"), 0.2);
}

}  // namespace
}  // namespace scree

#include "scree/output/saved_state.hpp"

#include "sample_state.hpp"
#include "scree/output/checkpoint.hpp"

namespace scree {
namespace {

using test::message_of;
using test::Scene;
using test::Scratch;

void write_step(const Scratch& scratch, const Scene& scene, int step) {
  scene.fill(scene.state, [&](const Index& node, int component) { return Scene::code(node, component) + step; });
  write_checkpoint(scratch.path(), step, scene.box, scene.dm, scene.fields, {{"state", scene.state}},
                   {{"time", 0.1 * step}}, {});
}

NodeBlock everything(const Box& box) { return {{}, nodes_of(box)}; }

SavedState read(const Scratch& scratch, const std::function<NodeBlock(const Box&)>& wanted = everything) {
  return read_state(PETSC_COMM_WORLD, scratch.path(), wanted);
}

TEST(SavedState, HasGridFieldsAndValuesOfTheNewestCheckpoint) {
  for (int dim = 1; dim <= 3; ++dim) {
    const Scratch scratch;
    const Scene scene(dim, dim == 2);
    for (const int step : {3, 4}) write_step(scratch, scene, step);
    const SavedState saved = read(scratch);
    EXPECT_EQ(saved.box.faces, scene.box.faces);
    EXPECT_EQ(saved.box.periodic, scene.box.periodic);
    EXPECT_DOUBLE_EQ(saved.time, 0.4);
    const Field* nu = saved.find("solids_fraction", -1);
    const Field* v = saved.find("velocity", dim - 1);
    ASSERT_TRUE(nu && v);
    EXPECT_EQ(saved.find("gas_pressure", -1), nullptr);
    EXPECT_EQ(saved.find("velocity", -1), nullptr);
    const Index node = unit(0) + 2 * unit(dim - 1);
    EXPECT_DOUBLE_EQ(saved.value(*nu, node), 2 * (Scene::code(node, 0) + 4));
    EXPECT_DOUBLE_EQ(saved.value(*v, node), 10 * dim * (Scene::code(node, dim) + 4));
    if (dim == 2) {
      EXPECT_DOUBLE_EQ(saved.value(*nu, node - 5 * unit(1)), saved.value(*nu, node)) << "periodic";
    }
  }
}

TEST(SavedState, EachRankHoldsWhatItAsksFor) {
  const Scratch scratch;
  const Scene scene(2);
  write_step(scratch, scene, 1);
  const int rank = test::this_rank();
  const SavedState saved = read(scratch, [&](const Box&) {
    return rank == 0 ? NodeBlock{{{2, 1, 0}}, {{3, 4, 1}}} : NodeBlock{{}, {{0, 0, 1}}};
  });
  ASSERT_EQ(saved.values.size(), rank == 0 ? 36U : 0U);
  if (rank > 0) return;
  const Index node{{4, 3, 0}};
  EXPECT_DOUBLE_EQ(saved.value(saved.fields[0], node), 2 * (Scene::code(node, 0) + 1));
}

TEST(SavedState, TakesTheOneBeforeADamagedOne) {
  const Scratch scratch;
  const Scene scene(1);
  for (const int step : {1, 2}) write_step(scratch, scene, step);
  if (test::this_rank() == 0) std::filesystem::resize_file(scratch / "checkpoints/00000002.h5", 1000);
  test::barrier();
  const SavedState saved = read(scratch);
  EXPECT_DOUBLE_EQ(saved.time, 0.1);
  EXPECT_NE(saved.remark.find("00000002.h5' cannot be used"), std::string::npos) << saved.remark;
}

TEST(SavedState, SaysWhatIsNoRun) {
  const Scratch scratch;
  EXPECT_NE(message_of([&] { read(scratch); }).find("no checkpoint in '"), std::string::npos);
  test::put(scratch / "checkpoints/00000001.h5", "no HDF5");
  EXPECT_NE(message_of([&] { read(scratch); }).find("cannot be used"), std::string::npos);
}

}  // namespace
}  // namespace scree

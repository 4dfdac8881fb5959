#include "scree/output/probes.hpp"

#include "sample_state.hpp"

namespace scree {
namespace {

using test::message_of;
using test::Scene;
using test::Scratch;

/// Position of a value along an axis: a face, or a centre.
double place(const Box& box, int axis, int node, bool face) {
  if (face) return box.faces[axis][node];
  return node < box.cells(axis) ? 0.5 * (box.faces[axis][node] + box.faces[axis][node + 1]) : 1e30;
}

double linear(const std::array<double, max_dim>& x) { return 1 + 2 * x[0] - 3 * x[1] + 5 * x[2]; }

/// Stored values that make each field in SI the same linear function of position.
void fill_linear(const Scene& scene) {
  scene.fill(scene.state, [&](const auto& node, int component) {
    std::array<double, max_dim> x{};
    for (int axis = 0; axis < scene.box.dim; ++axis) {
      x[axis] = place(scene.box, axis, node[axis], scene.fields[component].face_axis == axis);
    }
    return linear(x) / scene.fields[component].scale;
  });
}

TEST(ProbeSet, LinearFieldsAreExact) {
  for (int dim = 1; dim <= 3; ++dim) {
    const Scene scene(dim);
    fill_linear(scene);
    Point point{0.37, 0, 0};
    if (dim > 1) point[1] = 0.41;
    if (dim > 2) point[2] = 0.29;
    const ProbeSet probes(scene.box, scene.dm, scene.fields, {{"inside", point, {}}});
    const std::vector<double> values = probes.values(scene.state);
    ASSERT_EQ(values.size(), size_t(dim + 1));
    for (const double value : values) EXPECT_NEAR(value, linear(point), 1e-12);
    EXPECT_EQ(probes.columns()[0].name, "inside_solids_fraction");
    EXPECT_EQ(probes.columns()[1].name, "inside_velocity_x");
    EXPECT_EQ(probes.columns()[1].unit, "m/s");
  }
}

TEST(ProbeSet, SidesClipCellFieldsAndReachFaces) {
  const Scene scene(2);
  fill_linear(scene);
  const double top = scene.box.upper(1), left = 0;
  const ProbeSet probes(scene.box, scene.dm, scene.fields,
                        {{"corner", {left, top, 0}, {"solids_fraction", "velocity_y"}}});
  const std::vector<double> values = probes.values(scene.state);
  const double x = place(scene.box, 0, 0, false), y = place(scene.box, 1, 4, false);
  EXPECT_NEAR(values[0], linear({x, y, 0}), 1e-12);
  EXPECT_NEAR(values[1], linear({x, top, 0}), 1e-12);
}

TEST(ProbeSet, PeriodicAxesWrap) {
  const Scene scene(1, true);
  const Box& box = scene.box;
  const Field& nu = scene.fields[0];
  const double first = nu.scale * Scene::code({0, 0, 0}, 0), last = nu.scale * Scene::code({5, 0, 0}, 0);
  const double half_first = 0.5 * (box.faces[0][1] - box.faces[0][0]);
  const double half_last = 0.5 * (box.faces[0][6] - box.faces[0][5]);
  const ProbeSet probes(box, scene.dm, scene.fields,
                        {{"low", {0, 0, 0}, {"solids_fraction"}}, {"high", {box.upper(0), 0, 0}, {"solids_fraction"}}});
  const double expected = last + (first - last) * half_last / (half_first + half_last);
  for (const double value : probes.values(scene.state)) EXPECT_NEAR(value, expected, 1e-12);
}

TEST(ProbeSet, UnknownFieldsAndPointsOutsideAreRefused) {
  const Scene scene(2);
  const auto make = [&](const Probe& probe) {
    return message_of([&] { ProbeSet(scene.box, scene.dm, scene.fields, {probe}); });
  };
  EXPECT_NE(make({"a", {0.1, 0.1, 0}, {"pressure"}}).find("probe a: no field 'pressure'"), std::string::npos);
  EXPECT_NE(make({"b", {0.1, -1, 0}, {}}).find("probe b: y = -1 m is outside"), std::string::npos);
}

TEST(LineSampler, OneRowACellOfTheMainAxis) {
  const Scratch scratch;
  const Scene scene(2);
  fill_linear(scene);
  const LineSampler sampler(scene.box, scene.dm, scene.fields, {{"rise", {0.3, 0, 0}, {0.3, 0.75, 0}, {"velocity_y"}}});
  sampler.write(scratch.path(), 12, 0.5, scene.state);
  std::istringstream text(test::content(scratch / "lines/rise_000012.csv"));
  std::string line;
  std::getline(text, line);
  EXPECT_EQ(line, "time,x,y,velocity_y");
  for (int cell = 0; cell < scene.box.cells(1); ++cell) {
    double time = 0, x = 0, y = 0, v = 0;
    ASSERT_TRUE(std::getline(text, line));
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &time, &x, &y, &v), 4) << line;
    EXPECT_DOUBLE_EQ(y, place(scene.box, 1, cell, false));
    EXPECT_NEAR(v, linear({0.3, y, 0}), 1e-9);
  }
  EXPECT_FALSE(std::getline(text, line));
  test::barrier();
}

}  // namespace
}  // namespace scree

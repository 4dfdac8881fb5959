#include "scree/output/field_writer.hpp"

#include <hdf5.h>

#include "sample_state.hpp"

namespace scree {
namespace {

using test::Scene;
using test::Scratch;

/// Shape and values of a dataset, read by one rank without MPI-IO.
struct Dataset {
  std::vector<hsize_t> shape;
  std::vector<double> values;

  Dataset(const std::string& path, const std::string& name) {
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t data = H5Dopen2(file, name.c_str(), H5P_DEFAULT), space = H5Dget_space(data);
    shape.resize(H5Sget_simple_extent_ndims(space));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    values.resize(H5Sget_simple_extent_npoints(space));
    EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0) << name;
    H5Sclose(space);
    H5Dclose(data);
    H5Fclose(file);
  }
};

void expect_raw(const std::string& path, const std::string& name, const Scene& scene, const Field& field) {
  const Dataset data(path, name);
  std::array<int, max_dim> shape{1, 1, 1};
  for (int axis = 0; axis < scene.box.dim; ++axis) {
    shape[axis] = scene.box.cells(axis) + (axis == field.face_axis ? 1 : 0);
    EXPECT_EQ(data.shape[scene.box.dim - 1 - axis], hsize_t(shape[axis])) << name;
  }
  NodeBlock all;
  all.count = shape;
  size_t place = 0;
  for_each_node(all, [&](auto node) {
    for (int axis = 0; axis < scene.box.dim; ++axis) {
      if (scene.box.periodic[axis]) node[axis] %= scene.box.cells(axis);
    }
    EXPECT_EQ(data.values[place++], field.scale * Scene::code(node, field.component)) << name;
  });
}

void expect_file(const std::string& path, const Scene& scene) {
  const int dim = scene.box.dim;
  EXPECT_EQ(Dataset(path, "x_faces").values, scene.box.faces[0]);
  expect_raw(path, "solids_fraction", scene, scene.fields[0]);
  for (int axis = 0; axis < dim; ++axis) {
    expect_raw(path, std::string("velocity_") + "xyz"[axis] + "_face", scene, scene.fields[1 + axis]);
  }
  const Dataset velocity(path, "velocity");
  ASSERT_EQ(velocity.shape.size(), size_t(dim + 1));
  EXPECT_EQ(velocity.shape.back(), 3u);
  const Field& v_x = scene.fields[1];  // in the first cell: between nodes 0 and 1, or 0 and 0 + 1 on a periodic axis
  const double expected = v_x.scale * 0.5 * (Scene::code({0, 0, 0}, 1) + Scene::code({1, 0, 0}, 1));
  EXPECT_DOUBLE_EQ(velocity.values[0], expected);
  EXPECT_EQ(velocity.values[2] == 0, dim < 3);
}

TEST(FieldWriter, ValuesOfAllDimensionsAndPeriodicAxes) {
  for (int dim = 1; dim <= 3; ++dim) {
    for (const bool periodic : {false, true}) {
      const Scratch scratch;
      const Scene scene(dim, periodic);
      FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields);
      EXPECT_EQ(writer.write(0.25, scene.state), 0);
      if (test::this_rank() == 0) expect_file(scratch / "fields/000000.h5", scene);
      test::barrier();
    }
  }
}

TEST(FieldWriter, RestartKeepsEarlierEntriesAndDropsLaterOnes) {
  const Scratch scratch;
  const Scene scene(2);
  {
    FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields);
    for (const double time : {0.0, 0.1, 0.2}) writer.write(time, scene.state);
    EXPECT_EQ(writer.write(0.2, scene.state), 2) << "the same time replaces";
  }
  FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields, 0.1);
  EXPECT_EQ(writer.last_time(), 0.1);
  EXPECT_EQ(writer.write(0.15, scene.state), 2);
  const std::string text = test::content(scratch / "fields.xdmf");
  EXPECT_NE(text.find("Value=\"0.10000000000000001\""), std::string::npos);
  EXPECT_NE(text.find("Value=\"0.14999999999999999\""), std::string::npos);
  EXPECT_EQ(text.find("Value=\"0.20000000000000001\""), std::string::npos);
  EXPECT_NE(text.find("fields/000002.h5:/solids_fraction"), std::string::npos);
  EXPECT_EQ(text.find(scratch.path()), std::string::npos) << "paths are relative";
  test::barrier();
}

TEST(FieldWriter, GridAndBoxMustFit) {
  const Scratch scratch;
  const Scene scene(2), periodic(2, true);
  EXPECT_NE(test::message_of([&] { FieldWriter(scratch.path(), scene.box, periodic.dm, scene.fields); }), "");
}

}  // namespace
}  // namespace scree

#include "scree/output/field_writer.hpp"

#include <hdf5.h>

#include <filesystem>
#include <fstream>

#include "sample_state.hpp"
#include "scree/grid/axis_name.hpp"
#include "scree/output/time_average.hpp"

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
  Index shape{{1, 1, 1}};
  for (int axis = 0; axis < scene.box.dim; ++axis) {
    shape[axis] = scene.box.cells(axis) + (axis == field.face_axis ? 1 : 0);
    EXPECT_EQ(data.shape[scene.box.dim - 1 - axis], hsize_t(shape[axis])) << name;
  }
  size_t place = 0;
  for_each_node({}, shape, [&](Index node) {
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
    expect_raw(path, "velocity_" + axis_name(axis) + "_face", scene, scene.fields[1 + axis]);
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

TEST(FieldWriter, DerivedFieldsStandBesideTheUnknowns) {
  for (int dim = 1; dim <= 3; ++dim) {
    const Scratch scratch;
    const Scene scene(dim, dim == 2);
    CellField derived{{"frictional_pressure", "p_f", "Pa", "frictional pressure"}, {}};
    const NodeBlock owned = owned_block(checked_lattice(scene.box, scene.dm));
    for_each_node(owned.first, owned.count, [&](const Index& node) { derived.values.push_back(Scene::code(node, 3)); });
    FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields);
    writer.write(0.25, scene.state, {derived});
    if (test::this_rank() == 0) {
      Field stored = scene.fields[0];
      stored.component = 3;
      stored.scale = 1;
      expect_raw(scratch / "fields/000000.h5", "frictional_pressure", scene, stored);
      const std::string xml = test::content(scratch / "fields.xdmf");
      EXPECT_NE(xml.find("fields/000000.h5:/frictional_pressure"), std::string::npos);
    }
    test::barrier();
  }
}

TEST(FieldWriter, MeansStandBesideTheFields) {
  const Scratch scratch;
  const Scene scene(2);
  TimeAverage average(scene.dm, 1.0);
  average.add(1.0, 0.5, scene.state);
  EXPECT_TRUE(average.empty()) << "that step ended where the averages begin";
  Vec other = nullptr;
  check_petsc(VecDuplicate(scene.state, &other), "copy");
  scene.fill(other, [](const Index& node, int component) { return 5 * Scene::code(node, component); });
  average.add(1.25, 0.5, scene.state);  // half of it counts
  average.add(2.0, 0.75, other);
  FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields);
  writer.write(2.0, other, {}, average.mean());
  if (test::this_rank() == 0) {
    const std::string path = scratch / "fields/000000.h5";
    for (const std::string name : {"solids_fraction", "velocity", "velocity_x_face"}) {
      const Dataset mean(path, "mean_" + name), last(path, name);
      ASSERT_EQ(mean.shape, last.shape) << name;
      for (size_t k = 0; k < mean.values.size(); ++k)
        EXPECT_NEAR(mean.values[k], 0.8 * last.values[k], 1e-13 * std::abs(last.values[k])) << name;
    }
    EXPECT_NE(test::content(scratch / "fields.xdmf").find("fields/000000.h5:/mean_velocity"), std::string::npos);
  }
  test::barrier();
  check_petsc(VecDestroy(&other), "copy");
}

TEST(FieldWriter, RestartKeepsEarlierEntriesAndDropsLaterOnes) {
  const Scratch scratch;
  const Scene scene(2);
  {
    FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields);
    for (const double time : {0.0, 0.1, 0.2}) writer.write(time, scene.state);
    EXPECT_EQ(writer.write(0.2, scene.state), 2) << "the same time replaces";
  }
  namespace fs = std::filesystem;
  const fs::path directory(scratch.path());
  if (test::this_rank() == 0) {
    fs::create_directories(directory / "lines");
    for (const char* name : {"lines/axis_000001.csv", "lines/axis_000002.csv", "fields/000007.h5", "fields/notes.h5"})
      std::ofstream(directory / name) << "x";
  }
  test::barrier();
  FieldWriter writer(scratch.path(), scene.box, scene.dm, scene.fields, 0.1);
  EXPECT_EQ(writer.last_time(), 0.1);
  for (const char* kept : {"lines/axis_000001.csv", "fields/000000.h5", "fields/000001.h5", "fields/notes.h5"})
    EXPECT_TRUE(fs::exists(directory / kept)) << kept;
  for (const char* later : {"lines/axis_000002.csv", "fields/000002.h5", "fields/000007.h5"})
    EXPECT_FALSE(fs::exists(directory / later)) << later;
  EXPECT_EQ(test::content(scratch / "fields.xdmf").find("000002.h5"), std::string::npos);
  test::barrier();
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

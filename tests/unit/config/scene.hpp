/// A small valid case in PETSc's options database, for tests to change.
#pragma once

#include <gtest/gtest.h>
#include <petscsys.h>

#include <string>

#include "scree/config/read_case.hpp"

namespace scree {

/// Empties the database before and after each test.
class Options : public testing::Test {
 protected:
  void SetUp() override { clear(); }
  void TearDown() override { clear(); }

  static void clear() { ASSERT_EQ(PetscOptionsClear(nullptr), 0); }

  static void yaml(const std::string& text) { ASSERT_EQ(PetscOptionsInsertStringYAML(nullptr, text.c_str()), 0); }

  static void set(const std::string& key, const std::string& value) {
    ASSERT_EQ(PetscOptionsSetValue(nullptr, ("-" + key).c_str(), value.c_str()), 0);
  }

  static void erase(const std::string& key) { ASSERT_EQ(PetscOptionsClearValue(nullptr, ("-" + key).c_str()), 0); }

  /// Whether a remark on this case begins like that.
  static bool has_remark(const Case& scene, const std::string& start) {
    for (const std::string& remark : scene.remarks)
      if (remark.compare(0, start.size(), start) == 0) return true;
    return false;
  }

  /// A bin of 8 cm x 10 cm with cells of 1 cm x 2 cm.
  static void small_bin() {
    yaml(R"(
extent: [8 cm, 10 cm]
grid: {cells: [8, 5]}
gravity: [0, -9.81]
boundary:
  axis: {side: x_lower, kind: symmetry}
  wall: {side: x_upper, kind: wall_johnson_jackson}
  floor: {side: y_lower, kind: open}
  top: {side: y_upper, kind: open}
initial:
  bed: {solids_fraction: 0.6, box: [0, 8 cm, 0, 5 cm]}
)");
  }
};

}  // namespace scree

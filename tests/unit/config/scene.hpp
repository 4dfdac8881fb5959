/// A small valid case, for tests to change.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "scree/config/read_case.hpp"

namespace scree {

/// An input that starts empty.
class Options : public testing::Test {
 protected:
  void clear() { input = CaseInput(); }

  /// As a file, or one of overrides.
  void yaml(const std::string& text) { input.insert(yaml_entries(text, "test.yaml")); }

  /// As on the command line.
  void set(const std::string& key, const std::string& value) { input.set(key, value); }

  Case read_case() const { return scree::read_case(input); }

  /// The error that reading the case throws; one without a key if it throws none.
  InputError error_of_case() const {
    try {
      read_case();
    } catch (const InputError& error) {
      return error;
    }
    return {"", "", ""};
  }

  /// Whether a remark on this case begins like that.
  static bool has_remark(const Case& scene, const std::string& start) {
    for (const std::string& remark : scene.remarks)
      if (remark.compare(0, start.size(), start) == 0) return true;
    return false;
  }

  /// A bin of 8 cm x 10 cm with cells of 1 cm x 2 cm.
  void small_bin() {
    weightless_bin();
    set("gravity", "0, -9.81");
  }
  void weightless_bin() {
    yaml(R"(
extent: [8 cm, 10 cm]
grid: {cells: [8, 5]}
boundary:
  axis: {side: x_lower, kind: symmetry}
  wall: {side: x_upper, kind: wall_johnson_jackson}
  floor: {side: y_lower, kind: open}
  top: {side: y_upper, kind: open}
initial:
  bed: {solids_fraction: 0.6, box: [0, 8 cm, 0, 5 cm]}
)");
  }

  CaseInput input;
};

}  // namespace scree

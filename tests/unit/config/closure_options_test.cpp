#include <array>
#include <string>
#include <vector>

#include "scene.hpp"
#include "scree/closures/drag.hpp"
#include "scree/closures/rheology.hpp"

namespace scree {
namespace {

/// Options whose choices are what a list of closures holds.
class ClosureOptions : public Options {};

TEST_F(ClosureOptions, DefaultsAreThoseOfThePaper) {
  small_bin();
  yaml("gas: darcy");
  const Case scene = read_case();
  EXPECT_STREQ(scene.gas.drag_law->name, "wen_yu");
  EXPECT_STREQ(scene.kinetic.g0->name, "lun_savage");
  EXPECT_STREQ(scene.friction.pressure->name, "power");
  EXPECT_STREQ(scene.friction.model->name, "relaxed");
  EXPECT_EQ(scene.kinetic.mu_p, 0);
  EXPECT_EQ(scene.wall.mu_w, 0);
  EXPECT_EQ(scene.kinetic.length, nullptr);
  EXPECT_EQ(scene.friction.coefficient, FrictionCoefficient::constant);
  EXPECT_TRUE(scene.remarks.empty());
}

TEST_F(ClosureOptions, EveryVariantCanBeChosen) {
  const auto choose = [&](const std::string& key, const std::string& value) {
    clear();
    small_bin();
    set("gas", "darcy");
    set(key, value);
    return read_case();
  };
  const auto choose_without_gas = [&](const std::string& key, const std::string& value) {
    clear();
    small_bin();
    set(key, value);
    return read_case();
  };
  for (const DragLaw* law : drag_laws()) {
    const Case scene = choose("drag_law", law->name);
    EXPECT_EQ(scene.gas.drag_law, law);
    EXPECT_NE(scene.effective_yaml.find("drag_law: " + std::string(law->name)), std::string::npos);
  }
  for (const RadialDistribution* g0 : radial_distributions())
    EXPECT_EQ(choose("radial_distribution", g0->name).kinetic.g0, g0);
  for (const FrictionPressure* p_c : friction_pressures())
    EXPECT_EQ(choose("friction_pressure", p_c->name).friction.pressure, p_c);
  for (const EffectiveRestitution* form : effective_restitutions())
    EXPECT_EQ(choose("effective_restitution", form->name).kinetic.e_eff, form);
  for (const CorrelationLength* length : correlation_lengths())
    EXPECT_EQ(choose("correlation_length", length->name).kinetic.length, length);
  EXPECT_EQ(choose("correlation_length", "none").kinetic.length, nullptr);
  EXPECT_EQ(choose("friction_coefficient", "mu_i").friction.coefficient, FrictionCoefficient::mu_i);
  EXPECT_EQ(choose("friction_coefficient", "cidr").friction.coefficient, FrictionCoefficient::cidr);
  const Case nonlocal = choose_without_gas("friction_coefficient", "fluidity");
  EXPECT_EQ(nonlocal.friction.coefficient, FrictionCoefficient::fluidity);
  EXPECT_EQ(nonlocal.friction.fluctuation, 0);
  EXPECT_EQ(nonlocal.friction.fluidity.at_rough, nonlocal.friction.fluidity.g_min);
  clear();
  small_bin();
  yaml("friction: {angle: 20.9 deg, coefficient: mu_i_regularised}");
  EXPECT_EQ(read_case().friction.coefficient, FrictionCoefficient::mu_i_regularised);
  for (const FrictionModel model : friction_models())
    EXPECT_TRUE(choose("friction_model", model->name).friction.model == model);
}

TEST_F(ClosureOptions, WrongNamesListTheRightOnes) {
  const std::vector<std::array<std::string, 2>> rows{
      {"drag_law", "wen_yu, gidaspow, syamlal_obrien, beetstra, ergun"},
      {"radial_distribution", "lun_savage, carnahan_starling, ma_ahmadi"},
      {"friction_pressure", "power, schaeffer"},
      {"effective_restitution", "chialvo_sundaresan, jenkins_zhang"},
      {"correlation_length", "none, jenkins, berzi_vescovi"},
      {"friction_coefficient", "constant, mu_i, cidr, mu_i_regularised, fluidity"},
      {"friction_model", "none, critical_state, instantaneous, relaxed"}};
  for (const auto& [key, names] : rows) {
    clear();
    small_bin();
    set("gas", "darcy");
    set(key, "custom");
    try {
      read_case();
      ADD_FAILURE() << key << " takes any name";
    } catch (const InputError& error) {
      EXPECT_EQ(error.key, key);
      EXPECT_EQ(error.value, "custom");
      EXPECT_NE(error.expected.find(names), std::string::npos) << error.expected;
    }
  }
}

TEST_F(ClosureOptions, RemarksOnWhatTheSceneDoesNotUse) {
  const std::vector<std::array<std::string, 4>> rows{
      {"gas: none", "drag_law", "ergun", "gas is none"},
      {"friction_model: none", "friction_pressure", "power", "friction_model is none"},
      {"friction_pressure: schaeffer", "friction_pressure_constant", "0.05", "friction_pressure is not power"},
      {"friction_model: none", "friction_pressure_exponent_r", "2", "friction_model is none"},
      {"friction_model: none", "friction_coefficient", "cidr", "friction_model is none"},
      {"friction_tau: 1e-3", "friction_coefficient_limit", "0.6", "friction_coefficient is constant"},
      {"friction_tau: 1e-3", "friction_inertial_number", "0.2", "friction_coefficient is constant"},
      {"correlation_length: berzi_vescovi", "correlation_length_constant", "1", "correlation_length is not jenkins"}};
  for (const auto& [scene_text, key, value, why] : rows) {
    clear();
    small_bin();
    yaml(scene_text);
    set(key, value);
    const Case scene = read_case();
    EXPECT_EQ(scene.remarks.size(), 1u) << key;
    EXPECT_TRUE(has_remark(scene, key + " is not used: " + why)) << key;
  }
}

TEST_F(ClosureOptions, WallsHaveTheFrictionOfTheCaseUnlessTheySayOtherwise) {
  small_bin();
  set("wall_particle_friction", "0.1");
  set("boundary_wall_particle_friction", "0.4");
  set("particle_friction", "0.3");
  set("particle_density", "2450");
  const Case scene = read_case();
  EXPECT_EQ(scene.kinetic.mu_p, .3);
  EXPECT_EQ(scene.friction.rho_s, 2450) << "in the inertial number";
  for (const Segment& segment : scene.segments)
    EXPECT_EQ(segment.condition.wall.mu_w, segment.condition.name == "wall" ? .4 : .1) << segment.condition.name;
}

}  // namespace
}  // namespace scree

/// Scenes that together hold every boundary kind on every side, plates, periodic axes and graded cells.
#pragma once

#include <string>
#include <vector>

#include "../support/sample_problem.hpp"

namespace scree::test {

/// The choices that select which kernels and closures run.
struct Combination {
  int dim;
  FrictionModel friction;
  TemperatureModel temperature;
  AdvectionScheme advection;
  GasModel gas = GasModel::none;
};

inline std::string name_of(const Combination& c) {
  static const char* const temperatures[] = {"transport", "algebraic", "constant"};
  static const char* const schemes[] = {"upwind", "van_albada"};
  static const char* const gases[] = {"", "_darcy", "_incompressible"};
  return std::to_string(c.dim) + "d_" + c.friction->name + '_' + temperatures[static_cast<int>(c.temperature)] + '_' +
         schemes[static_cast<int>(c.advection)] + gases[static_cast<int>(c.gas)];
}

/// All combinations without gas in one and two dimensions; with gas some that hold every layout (T or not, chi or not)
/// with both advection schemes and each closure; in space one for each layout.
inline std::vector<Combination> combinations() {
  std::vector<Combination> all;
  const AdvectionScheme upwind = AdvectionScheme::upwind, van_albada = AdvectionScheme::van_albada;
  const TemperatureModel transport = TemperatureModel::transport, algebraic = TemperatureModel::algebraic,
                         constant = TemperatureModel::constant;
  for (int dim = 1; dim <= 2; ++dim) {
    for (const auto friction :
         {FrictionModel::none, FrictionModel::critical_state, FrictionModel::instantaneous, FrictionModel::relaxed})
      for (const auto temperature : {transport, algebraic, constant})
        for (const auto advection : {upwind, van_albada}) all.push_back({dim, friction, temperature, advection});
    for (const auto gas : {GasModel::darcy, GasModel::incompressible})
      for (const Combination& c : {Combination{dim, FrictionModel::relaxed, transport, upwind},
                                   Combination{dim, FrictionModel::relaxed, transport, van_albada},
                                   Combination{dim, FrictionModel::none, transport, upwind},
                                   Combination{dim, FrictionModel::instantaneous, transport, van_albada},
                                   Combination{dim, FrictionModel::relaxed, algebraic, upwind},
                                   Combination{dim, FrictionModel::relaxed, constant, van_albada},
                                   Combination{dim, FrictionModel::critical_state, constant, upwind},
                                   Combination{dim, FrictionModel::none, algebraic, van_albada}}) {
        all.push_back(c);
        all.back().gas = gas;
      }
  }
  for (const auto gas : {GasModel::none, GasModel::darcy, GasModel::incompressible})
    for (const Combination& c : {Combination{3, FrictionModel::relaxed, transport, van_albada},
                                 Combination{3, FrictionModel::instantaneous, transport, upwind},
                                 Combination{3, FrictionModel::relaxed, algebraic, upwind},
                                 Combination{3, FrictionModel::critical_state, constant, van_albada}}) {
      all.push_back(c);
      all.back().gas = gas;
    }
  return all;
}

struct NamedScene {
  std::string name;
  ProblemSetup setup;
};

/// The first axis is long enough for two ranks with the widest stencil (3 nodes each).
inline constexpr std::array<int, max_dim> sample_cells{6, 4, 3};

inline Condition sample_inlet() {
  Condition inlet = condition(BoundaryKind::inlet, {0.03, -0.02, 0.01});
  inlet.bring(SolidsContinuity::unknown, 0.56);
  inlet.bring(GranularEnergy::unknown, 2e-4);
  inlet.bring(FrictionRelaxation::unknown, 0.9);
  inlet.gas_velocity = 0.04;
  return inlet;
}

/// Varies along y (along x on sides where that is across) and with time.
inline Condition sample_gas_inlet() {
  Condition inlet = condition(BoundaryKind::gas_inlet);
  inlet.gas_velocity = 0.2;
  inlet.gas_variation.axis = 1;
  inlet.gas_variation.profile.at = {1e-3, 4e-3, 7e-3};
  inlet.gas_variation.profile.factor = {0.3, 1.2, -0.5};
  inlet.gas_variation.history.at = {0, 2};
  inlet.gas_variation.history.factor = {0.7, 1.5};
  return inlet;
}

/// An open side with gas at a pressure of its own outside.
inline Condition sample_opening() {
  Condition opening = condition(BoundaryKind::open);
  opening.gas_pressure = 3;
  return opening;
}

/// A wall to which the gas sticks too.
inline Condition sticky(Condition wall) {
  wall.gas_no_slip = true;
  return wall;
}

/// A plate normal to `axis` in the middle of the box, with an opening that leaves a lip on both sides.
inline Plate sample_plate(const Box& box, int axis, const Condition& condition) {
  Plate plate;
  plate.condition = condition;
  plate.axis = axis;
  plate.position = box.faces[axis][static_cast<std::size_t>(box.cells(axis) / 2)];
  Patch opening;
  for (int other = 0; other < box.dim; ++other) {
    if (other == axis) continue;
    opening.lower[other] = box.faces[other][1];
    opening.upper[other] = box.faces[other][2];
  }
  plate.openings.push_back(opening);
  return plate;
}

/// The same kind on all sides, walls moving along themselves.
inline std::vector<NamedScene> scenes_of_one_kind(const ProblemSetup& base) {
  const std::array<double, max_dim> moving{0.02, -0.03, 0.01};
  std::vector<NamedScene> scenes;
  const auto add = [&](const std::string& name, const Condition& condition) {
    scenes.push_back({name, base});
    scenes.back().setup.segments = all_sides(base.box, condition);
  };
  add("wall_johnson_jackson", condition(BoundaryKind::wall_johnson_jackson));
  add("wall_johnson_jackson moving", condition(BoundaryKind::wall_johnson_jackson, moving));
  add("wall_free_slip", condition(BoundaryKind::wall_free_slip));
  add("wall_no_slip moving", condition(BoundaryKind::wall_no_slip, moving));
  add("symmetry", condition(BoundaryKind::symmetry));
  add("open", sample_opening());
  add("inlet", sample_inlet());
  return scenes;
}

/// Different kinds on the sides of each axis and on parts of one side, and plates across each axis.
inline std::vector<NamedScene> scenes_of_mixed_kinds(const ProblemSetup& base) {
  std::vector<NamedScene> scenes{{"mixed sides and plates", base}, {"mixed sides, parts", base}};
  ProblemSetup& plates = scenes[0].setup;
  plates.segments.clear();
  const Condition kinds[] = {condition(BoundaryKind::wall_no_slip),
                             condition(BoundaryKind::open),
                             condition(BoundaryKind::wall_johnson_jackson),
                             sample_inlet(),
                             condition(BoundaryKind::symmetry),
                             condition(BoundaryKind::wall_free_slip)};
  int next = 0;
  for (int axis = 0; axis < base.box.dim; ++axis) {
    for (const bool upper : {false, true}) plates.segments.push_back(side(axis, upper, kinds[next++]));
    const Condition on_plate = axis == 0   ? condition(BoundaryKind::wall_johnson_jackson, {0, 0.02, -0.01})
                               : axis == 1 ? condition(BoundaryKind::wall_no_slip)
                                           : condition(BoundaryKind::wall_free_slip);
    plates.plates.push_back(sample_plate(base.box, axis, on_plate));
  }

  ProblemSetup& parts = scenes[1].setup;
  for (int axis = 0; axis < base.box.dim; ++axis)
    for (const bool upper : {false, true}) {
      Segment middle = side(axis, upper, upper ? sample_inlet() : condition(BoundaryKind::open));
      for (int other = 0; other < base.box.dim; ++other) {
        if (other == axis) continue;
        middle.patch.lower[other] = base.box.faces[other][1];
        middle.patch.upper[other] = base.box.faces[other][2];
      }
      parts.segments.push_back(middle);
    }
  return scenes;
}

/// Periodic in one axis after the other, then in all.
inline std::vector<NamedScene> periodic_scenes(const ProblemSetup& base) {
  std::vector<NamedScene> scenes;
  for (int axis = 0; axis <= base.box.dim; ++axis) {
    const bool all = axis == base.box.dim;
    if (all && base.box.dim == 1) break;
    scenes.push_back({all ? std::string("periodic in all axes") : std::string("periodic in ") + "xyz"[axis], base});
    ProblemSetup& setup = scenes.back().setup;
    for (int a = 0; a < base.box.dim; ++a) setup.box.periodic[a] = all || a == axis;
    setup.segments = all_sides(setup.box, condition(BoundaryKind::wall_johnson_jackson, {0.01, 0.01, 0.01}));
  }
  return scenes;
}

/// What no boundary decides.
inline std::vector<NamedScene> scenes_of_options(const ProblemSetup& base) {
  std::vector<NamedScene> scenes{{"no strain rate fluctuation", base},
                                 {"fixed solids", base},
                                 {"gravity", base},
                                 {"some strain rate fluctuation", base}};
  scenes[0].setup.solids.friction.fluctuation = 0;
  scenes[1].setup.model.solids_moving = false;
  scenes[2].setup.model.gravity = {1.0, -9.81, 0.5};
  scenes[2].setup.model.solids_fraction_floor = 1e-3;
  scenes[3].setup.solids.friction.fluctuation = 0.1;
  return scenes;
}

/// What only gas knows: inlets of gas, a pressure outside, viscous stress with walls to which it sticks.
inline std::vector<NamedScene> scenes_of_gas(const ProblemSetup& base) {
  std::vector<NamedScene> scenes;
  if (base.solids.gas.model == GasModel::none) return scenes;
  const auto add = [&](const std::string& name) -> ProblemSetup& {
    scenes.push_back({name, base});
    scenes.back().setup.model.gas_viscous_stress = true;
    return scenes.back().setup;
  };
  add("gas inlets").segments = all_sides(base.box, sample_gas_inlet());

  ProblemSetup& plates = add("gas, mixed sides and plates");
  plates.segments.clear();
  const Condition kinds[] = {sample_gas_inlet(),
                             sample_opening(),
                             sticky(condition(BoundaryKind::wall_johnson_jackson, {0.02, 0, 0.01})),
                             sample_inlet(),
                             sticky(condition(BoundaryKind::wall_free_slip, {0.01, -0.03, 0})),
                             condition(BoundaryKind::symmetry)};
  int next = 0;
  for (int axis = 0; axis < base.box.dim; ++axis) {
    for (const bool upper : {false, true}) plates.segments.push_back(side(axis, upper, kinds[next++]));
    Condition plate = condition(BoundaryKind::wall_no_slip, {axis == 0 ? 0 : 0.02, axis == 1 ? 0 : 0.01, 0});
    plate.gas_no_slip = axis != 1;
    plates.plates.push_back(sample_plate(base.box, axis, plate));
  }

  ProblemSetup& parts = add("gas, parts of sides");
  for (int axis = 0; axis < base.box.dim; ++axis)
    for (const bool upper : {false, true}) {
      Segment middle = side(axis, upper, upper ? sample_opening() : sample_gas_inlet());
      for (int other = 0; other < base.box.dim; ++other) {
        if (other == axis) continue;
        middle.patch.lower[other] = base.box.faces[other][1];
        middle.patch.upper[other] = base.box.faces[other][2];
      }
      parts.segments.push_back(middle);
    }
  if (base.solids.gas.model == GasModel::darcy) return scenes;  // without viscous stress

  add("viscous gas between moving walls").segments =
      all_sides(base.box, sticky(condition(BoundaryKind::wall_johnson_jackson, {0.02, -0.03, 0.01})));
  ProblemSetup& periodic = add("viscous gas, periodic");
  periodic.box.periodic = {true, true, true};
  periodic.segments.clear();
  ProblemSetup& alone = add("gas alone");
  alone.model.solids_moving = false;
  alone.model.gas_alone = true;
  return scenes;
}

/// M(I) and its flow rules.
inline std::vector<NamedScene> scenes_of_inertial_friction(const ProblemSetup& base) {
  std::vector<NamedScene> scenes{{"mu(I)", base}, {"mu(I), consistent flow rule", base}, {"mu(I), regularised", base}};
  scenes[0].setup.solids.friction.coefficient = FrictionCoefficient::mu_i;
  scenes[1].setup.solids.friction.coefficient = FrictionCoefficient::cidr;
  scenes[2].setup.solids.friction.coefficient = FrictionCoefficient::mu_i_regularised;
  scenes[2].setup.solids.friction.phi = std::asin(.3819);
  return scenes;
}

/// Each closure that can be chosen: drag laws, g0, p_c, the dissipation with friction and with L, M(I).
inline std::vector<NamedScene> scenes_of_closures(const ProblemSetup& base) {
  std::vector<NamedScene> scenes;
  const auto add = [&](const std::string& what, const char* name) -> SolidsParameters& {
    scenes.push_back({what + ' ' + name, base});
    return scenes.back().setup.solids;
  };
  if (base.solids.gas.model != GasModel::none)
    for (const DragLaw* law : drag_laws()) add("drag law", law->name).gas.drag_law = law;
  for (const RadialDistribution* g0 : radial_distributions()) add("radial distribution", g0->name).kinetic.g0 = g0;
  for (const FrictionPressure* p_c : friction_pressures()) {
    SolidsParameters& solids = add("friction pressure", p_c->name);
    solids.friction.pressure = p_c;
    if (p_c != default_friction_pressure()) solids.friction.nu_min = .6;  // so that a penalty does not drown the rest
  }
  for (const EffectiveRestitution* form : effective_restitutions()) {
    KineticParameters& kinetic = add("effective restitution", form->name).kinetic;
    kinetic.mu_p = .3;
    kinetic.e_eff = form;
    for (Segment& segment : scenes.back().setup.segments) segment.condition.wall.mu_w = .2;
  }
  for (const CorrelationLength* length : correlation_lengths()) {
    KineticParameters& kinetic = add("correlation length", length->name).kinetic;
    kinetic.mu_p = .3;
    kinetic.length = length;
    kinetic.length_constant = 1;
  }
  for (NamedScene& scene : scenes_of_inertial_friction(base)) scenes.push_back(std::move(scene));
  return scenes;
}

inline ProblemSetup sample_setup(const Combination& c) {
  return sample_setup(graded_box(c.dim, sample_cells), c.friction, c.temperature, c.advection, c.gas);
}

/// Scenes in which many kinds of boundary meet.
inline std::vector<NamedScene> mixed_scenes(const ProblemSetup& base) {
  std::vector<NamedScene> scenes = scenes_of_mixed_kinds(base);
  for (NamedScene& scene : scenes_of_gas(base)) scenes.push_back(std::move(scene));
  return scenes;
}

/// Fluidity, held at walls without slip or free there.
inline std::vector<NamedScene> scenes_of_fluidity(const ProblemSetup& base) {
  std::vector<NamedScene> scenes;
  for (const bool held : {true, false})
    for (NamedScene& scene : mixed_scenes(base)) {
      scene.name += held ? ", held at rough walls" : ", free at rough walls";
      FrictionParameters& friction = scene.setup.solids.friction;
      friction.coefficient = FrictionCoefficient::fluidity;
      friction.fluidity.held_at_rough = held;
      friction.fluidity.at_rough = 3;
      friction.fluctuation = 0;
      friction.flow_rule_floor = 1;
      scenes.push_back(std::move(scene));
    }
  return scenes;
}

inline std::vector<NamedScene> all_scenes(const ProblemSetup& base) {
  std::vector<NamedScene> scenes;
  for (auto* make : {scenes_of_one_kind, scenes_of_mixed_kinds, periodic_scenes, scenes_of_options, scenes_of_gas})
    for (NamedScene& scene : make(base)) scenes.push_back(std::move(scene));
  return scenes;
}

/// All scenes in one and two dimensions, and in three for the models with most terms. For the others in three
/// dimensions those that hold each kind of boundary, on sides and on plates, and that with all axes periodic.
inline std::vector<NamedScene> scenes_for(const Combination& c) {
  const ProblemSetup base = sample_setup(c);
  const bool largest = c.friction == FrictionModel::relaxed && c.temperature == TemperatureModel::transport;
  if (c.dim < 3 || largest) return all_scenes(base);
  std::vector<NamedScene> scenes = mixed_scenes(base);
  scenes.push_back(periodic_scenes(base).back());
  return scenes;
}

}  // namespace scree::test

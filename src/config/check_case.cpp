#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "scree/closures/inertial.hpp"
#include "scree/config/case_options.hpp"
#include "scree/config/side_samples.hpp"

namespace scree {
namespace {

std::string point_text(const std::array<double, max_dim>& point, int dim) {
  std::string text;
  for (int axis = 0; axis < dim; ++axis) text += (axis ? ", " : "") + number_text(point[axis]);
  return text;
}

void check_inside(const Box& box, const std::array<double, max_dim>& point, const std::string& key) {
  for (int axis = 0; axis < box.dim; ++axis) {
    if (point[axis] >= box.lower(axis) && point[axis] <= box.upper(axis)) continue;
    throw InputError(key, point_text(point, box.dim),
                     std::string("a point in the box, which along axis ") + axis_names[axis] + " is from " +
                         number_text(box.lower(axis)) + " to " + number_text(box.upper(axis)) + " m");
  }
}

void check_covered(const Box& box, int axis, bool upper, const std::vector<Segment>& segments, double end_time) {
  const std::string side = side_name(axis, upper);
  if (segments.empty())
    throw InputError("side " + side, "",
                     "segments boundary_<name>_side " + side + " that cover it, or periodic " + axis_names[axis]);
  std::set<double> cuts;
  for (const Segment& segment : segments) cuts.insert({segment.condition.from, segment.condition.until});
  for (const double time : middles(cuts, 0.0, end_time > 0 ? end_time : 1.0)) {
    for (const auto& point : side_samples(box, axis, segments)) {
      if (holding(segments, point, box.dim, time)) continue;
      auto place = point;
      place[axis] = upper ? box.upper(axis) : box.lower(axis);
      throw InputError("side " + side, "",
                       "segments that cover all of it at all times; none holds at (" + point_text(place, box.dim) +
                           ") m at time " + number_text(time) + " s");
    }
  }
}

void check_times(const std::string& key, double time, const std::string& earlier_key, double earlier) {
  if (!(earlier < time))
    throw InputError(key, number_text(time) + " s",
                     "a time after " + earlier_key + " = " + number_text(earlier) + " s");
}

void check_boundaries(const Case& the_case) {
  const Box& box = the_case.box;
  for (const Segment& segment : the_case.segments) {
    const std::string key = "boundary_" + segment.condition.name;
    if (box.periodic[segment.axis])
      throw InputError(key + "_side", side_name(segment.axis, segment.upper), "a side of an axis that is not periodic");
    check_times(key + "_until", segment.condition.until, key + "_from", segment.condition.from);
  }
  for (int axis = 0; axis < box.dim; ++axis) {
    for (const bool upper : {false, true}) {
      if (box.periodic[axis]) continue;
      check_covered(box, axis, upper, segments_of_side(the_case.segments, axis, upper), the_case.time.end_time);
    }
  }
}

void check_plates(const Case& the_case) {
  for (const Plate& plate : the_case.plates) {
    const std::string key = "plate_" + plate.condition.name + "_";
    const double lower = the_case.box.lower(plate.axis), upper = the_case.box.upper(plate.axis);
    if (!(plate.position > lower && plate.position < upper))
      throw InputError(key + "position", number_text(plate.position) + " m",
                       "a grid plane inside the box, between " + number_text(lower) + " and " + number_text(upper) +
                           " m; use boundary_<name> for its sides");
    if (plate.condition.velocity[plate.axis] != 0)
      throw InputError(key + "velocity", point_text(plate.condition.velocity, the_case.box.dim),
                       "a velocity in the plane of the plate");
    check_times(key + "until", plate.condition.until, key + "from", plate.condition.from);
    if (plate.slides()) check_times(key + "slide_until", plate.slide_until, key + "slide_from", plate.slide_from);
  }
}

/// The file of a region's table, into table_values.
void read_table(const Case& the_case, InitialRegion& region) {
  const std::string key = "initial_" + region.name + "_table";
  const auto wrong = [&](const std::string& expected) { return InputError(key, region.table, expected); };
  std::ifstream in(region.table);
  if (!in) throw wrong("a file that can be read");
  const std::string form = "lines 'coordinate solids_fraction' in SI, ";
  std::vector<double>&x = region.table_values.at, &nu = region.table_values.factor;
  for (std::string line; std::getline(in, line);) {
    const auto start = line.find_first_not_of(" \t\r");
    if (start == std::string::npos || line[start] == '#') continue;
    const std::string got = "but it has '" + line + "'";
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream numbers(line);
    double coordinate, value;
    std::string more;
    if (!(numbers >> coordinate >> value) || numbers >> more) throw wrong(form + "two finite numbers each, " + got);
    if (!x.empty() && !(coordinate > x.back())) throw wrong(form + "ascending coordinates, " + got);
    if (!(value >= 0 && value < the_case.kinetic.nu_max))
      throw wrong(form + "each in [0, solids_fraction_max = " + number_text(the_case.kinetic.nu_max) + "), " + got);
    x.push_back(coordinate);
    nu.push_back(value);
  }
  if (x.empty()) throw wrong(form + "at least one");
}

void check_region(const Case& the_case, const InitialRegion& region) {
  const std::string key = "initial_" + region.name + "_";
  for (int axis = 0; axis < the_case.box.dim; ++axis) {
    if (!(region.lower[axis] < region.upper[axis]))
      throw InputError(key + "box", number_text(region.lower[axis]) + ", " + number_text(region.upper[axis]),
                       std::string("lower below upper, inside the box, along axis ") + axis_names[axis]);
  }
  const bool equilibrium = region.profile == InitialRegion::Profile::equilibrium;
  if (!region.run.empty() && (equilibrium || !region.table.empty()))
    throw InputError(key + "run", region.run,
                     std::string("no run where ") + (equilibrium ? "profile is equilibrium" : "a table is given") +
                         ", which gives the solids fraction too");
  if (!equilibrium) return;
  if (!region.table.empty()) throw InputError(key + "table", region.table, "no table where profile is equilibrium");
  const auto& g = the_case.model.gravity;
  if (std::count_if(g.begin(), g.end(), [](double component) { return component != 0; }) != 1)
    throw InputError(key + "profile", "equilibrium",
                     "gravity along one axis, but gravity is " + point_text(g, the_case.box.dim));
  if (!the_case.friction.model->has_friction)
    throw InputError(key + "profile", "equilibrium",
                     "a friction_model other than none, for p_c (18) carries the column");
}

const char* name_of(FrictionCoefficient coefficient) {
  if (coefficient == FrictionCoefficient::cidr) return "cidr";
  if (coefficient == FrictionCoefficient::fluidity) return "fluidity";
  return coefficient == FrictionCoefficient::mu_i ? "mu_i" : "mu_i_regularised";
}

/// The balance of fluidity is compiled for few scenes.
void check_fluidity(const Case& the_case) {
  if (!has_fluidity(the_case.friction)) return;
  const auto asks = [](const std::string& what) {
    throw InputError("friction_coefficient", "fluidity", "another one where " + what);
  };
  if (the_case.friction.model != FrictionModel::relaxed)
    asks(std::string("friction_model is ") + the_case.friction.model->name + "; fluidity takes relaxed");
  if (the_case.gas.model != GasModel::none) asks("there is a gas; fluidity takes gas none");
  if (the_case.box.dim != 2)
    asks("dimension is " + std::to_string(the_case.box.dim) + "; fluidity takes two dimensions");
}

/// M(I): known to the models that take it, and growing with I.
void check_friction_coefficient(const FrictionParameters& friction) {
  if (!friction.model->has_friction || !has_inertial_coefficient(friction)) return;
  if (friction.model != FrictionModel::critical_state && friction.model != FrictionModel::relaxed)
    throw InputError("friction_coefficient", name_of(friction.coefficient),
                     std::string("constant for friction_model ") + friction.model->name +
                         "; critical_state and relaxed take another one");
  if (!(friction.mu_2 >= std::sin(friction.phi)))
    throw InputError("friction_coefficient_limit", number_text(friction.mu_2),
                     "at least sin(friction_angle) = " + number_text(std::sin(friction.phi), 6));
  if (friction.coefficient == FrictionCoefficient::mu_i_regularised && std::isnan(neutral_inertial_number(friction)))
    throw InputError("friction_coefficient", name_of(friction.coefficient),
                     "cidr: with this friction_angle and friction_coefficient_limit mu(I) is well-posed at no I");
}

/// The fits of effective restitution end where it does.
void check_restitution(const EffectiveRestitution& form, const std::string& key, double mu, const std::string& key_e,
                       double e) {
  if (mu == 0 || form.e_eff(e, mu) >= 0) return;
  throw InputError(key, number_text(mu),
                   std::string("a friction that leaves an effective_restitution (") + form.name +
                       ") of at least 0; with " + key_e + " = " + number_text(e) + " it is " +
                       number_text(form.e_eff(e, mu), 3));
}

void check_restitutions(const Case& the_case) {
  const EffectiveRestitution& form = *the_case.kinetic.e_eff;
  check_restitution(form, "particle_friction", the_case.kinetic.mu_p, "particle_restitution", the_case.kinetic.e_p);
  check_restitution(form, "wall_particle_friction", the_case.wall.mu_w, "wall_restitution", the_case.wall.e_w);
  const auto check_condition = [&](const std::string& key, const Condition& condition) {
    check_restitution(form, key + "particle_friction", condition.wall.mu_w, key + "restitution", condition.wall.e_w);
  };
  for (const Segment& segment : the_case.segments)
    check_condition("boundary_" + segment.condition.name + "_", segment.condition);
  for (const Plate& plate : the_case.plates) check_condition("plate_" + plate.condition.name + "_", plate.condition);
}

void check_friction(const FrictionParameters& friction) {
  check_friction_coefficient(friction);
  if (friction.model->uses_flow_rule && !(friction.n_dilation > 1))
    throw InputError("friction_exponent_dilation", number_text(friction.n_dilation),
                     "a number, > 1; give it for a friction_angle of 60 deg or more, where its default is not");
}

/// The stencil of advection reaches over as many nodes; an axis that is not periodic has one more than cells.
void check_cells(const Case& the_case) {
  const bool upwind = the_case.model.advection == AdvectionScheme::upwind;
  for (int axis = 0; axis < the_case.box.dim; ++axis) {
    const int least = (upwind ? 2 : 3) - (the_case.box.periodic[axis] ? 0 : 1), cells = the_case.box.cells(axis);
    if (cells < least)
      throw InputError("grid", std::to_string(cells) + (cells == 1 ? " cell" : " cells") + " along " + axis_names[axis],
                       "at least " + std::to_string(least) + " for advection " + (upwind ? "upwind" : "van_albada"));
  }
}

void check_lagging(const FrictionParameters& friction, const TimeParameters& time) {
  if (friction.lagged && (time.adaptive || time.scheme != TimeScheme::beuler))
    throw InputError("friction_lagged", "yes", "no, or time_step_adaptive no and time_scheme beuler");
}

void check_time(const TimeParameters& time) {
  if (!time.adaptive) return;
  const std::string initial = number_text(time.step_initial) + " s";
  if (time.step_min > time.step_initial)
    throw InputError("time_step_initial", initial, "at least time_step_min = " + number_text(time.step_min) + " s");
  if (time.step_max < time.step_initial)
    throw InputError("time_step_initial", initial, "at most time_step_max = " + number_text(time.step_max) + " s");
}

void check_output(const Case& the_case) {
  for (const Probe& probe : the_case.probes) check_inside(the_case.box, probe.point, "probe_" + probe.name + "_point");
  for (const Line& line : the_case.lines) {
    check_inside(the_case.box, line.from, "line_" + line.name + "_from");
    check_inside(the_case.box, line.to, "line_" + line.name + "_to");
    if (line.from == line.to)
      throw InputError("line_" + line.name + "_to", point_text(line.to, the_case.box.dim),
                       "a point other than its from");
  }
  if (the_case.output.directory.empty()) throw InputError("output_dir", "", "a directory");
}

}  // namespace

void check_case(Case& the_case) {
  check_restitutions(the_case);
  check_friction(the_case.friction);
  check_fluidity(the_case);
  check_cells(the_case);
  check_lagging(the_case.friction, the_case.time);
  check_time(the_case.time);
  check_boundaries(the_case);
  check_plates(the_case);
  check_gas(the_case);
  for (InitialRegion& region : the_case.initial) {
    check_region(the_case, region);
    if (!region.table.empty()) read_table(the_case, region);
  }
  check_ways_out(the_case);
  check_output(the_case);
}

}  // namespace scree

/// A whole scene, validated and in SI: what the case file and the command line say.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "scree/assembly/parameters.hpp"
#include "scree/boundary/segment.hpp"
#include "scree/closures/friction.hpp"
#include "scree/closures/gas.hpp"
#include "scree/closures/kinetic.hpp"
#include "scree/closures/wall.hpp"
#include "scree/config/catalogue.hpp"
#include "scree/grid/box.hpp"
#include "scree/grid/sampling.hpp"
#include "scree/grid/unknown.hpp"
#include "scree/stepping/choices.hpp"

namespace scree {

/// A value of an unknown at t = 0 [SI]; vectors have one an axis.
struct InitialValue {
  const Unknown* unknown = nullptr;
  std::array<double, max_dim> value{0, 0, 0};
};

/// Values of a region at t = 0; regions are applied in the order of the list.
struct InitialRegion {
  std::string name;
  std::array<double, max_dim> lower, upper;  ///< box [m]
  enum class Profile {
    uniform,
    equilibrium
  } profile = Profile::uniform;  ///< equilibrium: nu from p_c' dnu/dz = nu rho_s g (T4), or (T5)
  double janssen_width = 0;      ///< > 0: equilibrium with wall friction in a plane bin of this width (T5) [m]
  double surface = 0;            ///< equilibrium: coordinate of the free surface along gravity's axis [m]
  std::string table;             ///< absolute path of lines "coordinate solids_fraction" along table_axis; empty: none
  Ramp table_values;             ///< what it holds: factor is the solids fraction
  int table_axis = 0;
  std::string run;                   ///< directory of a run whose last state fills the region; empty: none
  std::vector<InitialValue> values;  ///< of the unknowns that the region gives; the others stay as they are
  std::array<double, max_dim * max_dim>
      velocity_gradient{};  ///< dv_i/dx_j at [3*i + j]; v = velocity + gradient (x - box origin) [1/s]

  /// Whether nu comes from a table, a profile or another run.
  bool has_own_solids_fraction() const { return profile != Profile::uniform || !table.empty() || !run.empty(); }
  bool gives_solids_fraction() const { return has_own_solids_fraction() || find(SolidsContinuity::unknown); }
  /// nu where it is uniform; 0 where the region says nothing of it.
  double uniform_solids_fraction() const {
    const InitialValue* nu = find(SolidsContinuity::unknown);
    return nu ? nu->value[0] : 0;
  }
  const InitialValue* find(const Unknown& unknown) const {
    for (const InitialValue& entry : values)
      if (entry.unknown == &unknown) return &entry;
    return nullptr;
  }
  /// Whether a point lies in its box.
  bool holds(const std::array<double, max_dim>& point, int dim) const;
};

/// A named plane of grid faces through which monitor.csv reports the solids mass flow rate [kg/s].
struct FluxPlane {
  std::string name;
  int axis = 1;
  double position = 0;
  Patch patch;
  bool upward = false;  ///< sign: positive along +axis when true, along -axis (discharge) when false
};

/// The flow of gas along periodic axes, where it is given instead of the pressure gradient.
struct HeldGasFlow {
  bool held = false;
  std::array<double, max_dim> velocity{0, 0, 0};  ///< superficial, mean over the box [m/s]
};

struct TimeParameters {
  TimeScheme scheme = TimeScheme::beuler;
  double end_time = 1;
  double step_initial = 1e-6;
  double step_min = 1e-12;
  double step_max = std::numeric_limits<double>::infinity();
  double accuracy = 0.1;  ///< relative error in time that is asked for; the one accuracy knob
  bool adaptive = true;   ///< false: fixed step = step_initial
};

struct OutputParameters {
  std::string directory = "out";
  double field_interval = 0;                                      ///< [s]; 0: only initial and final fields
  double average_from = std::numeric_limits<double>::infinity();  ///< start of time averages [s]; infinite: none
  bool wall_stress = false;                                       ///< forces and stresses of the particles on walls
  double checkpoint_interval = 0;                                 ///< simulated [s]; 0: only at the end
  double wall_clock_budget = 0;                                   ///< [s]; 0: none
  int monitor_every = 1;                                          ///< steps between rows of monitor.csv
  double depth = 0.01;               ///< plane flow: thickness of the slab that masses and rates refer to [m]
  double mirror = 1;                 ///< factor on masses and rates, 2 for half a domain
  double bed_solids_fraction = 0.3;  ///< nu that marks the bed surface in bed_height
  std::string restart;               ///< directory to go on from; empty: none
  bool overwrite = false;            ///< allow a directory that already holds a run
};

/// An option that is PETSc's to understand.
struct PetscOption {
  std::string key, value;  ///< without '-'; an empty value is none
  bool on_command_line = false;
};

struct SolverParameters {
  SolverPreset preset = SolverPreset::ilu;
  bool preset_given = false;  ///< one that was not may change on the way
  TangentKind tangent = TangentKind::stress_velocity;
  bool extrapolate = true;
  bool view = false;  ///< print the solver's set-up and the PETSc options it stands for
};

struct Case {
  Catalogue catalogue;  ///< what its options may choose from
  Box box;
  ModelParameters model;
  KineticParameters kinetic;
  FrictionParameters friction;
  GasParameters gas;
  HeldGasFlow gas_flow;
  WallParameters wall;  ///< defaults of the segments
  std::vector<Segment> segments;
  std::vector<Plate> plates;
  std::vector<InitialRegion> initial;
  std::vector<Probe> probes;
  std::vector<Line> lines;
  std::vector<FluxPlane> flux_planes;
  TimeParameters time;
  OutputParameters output;
  SolverParameters solver;
  double scale_velocity = 0;               ///< [m/s]; 0: sqrt(g d), or 0.1 m/s without gravity
  bool check_only = false;                 ///< nothing is to be run
  std::string effective_yaml;              ///< the case as understood, as a case file that reruns it
  std::vector<PetscOption> petsc_options;  ///< what PETSc is to know
  std::vector<std::string> grid_summary;   ///< lines about the grid, for -check
  std::vector<std::string> remarks;        ///< for the log: a line for what is not used, odd or has a former name

  /// The last region at a point that gives a solids fraction; nullptr if there is none.
  const InitialRegion* solids_region(const std::array<double, max_dim>& point) const;
  /// Whether particles are there from the start or come in.
  bool has_particles() const;
};

/// Whether a side of this condition lets particles in.
bool brings_particles(const Condition& condition);

}  // namespace scree

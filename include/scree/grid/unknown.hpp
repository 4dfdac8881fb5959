/// What is known of an unknown of the model, stated once where its balance stands (balances/): layout, fields, scales,
/// Newton's limits, error norm, options of initial state and inlets, checkpoints and output follow from it.
#pragma once

#include <limits>
#include <string>

#include "scree/grid/axis_name.hpp"

namespace scree {

/// Scales that make unknowns and residuals dimensionless: SI value = scale * stored value.
struct Scales {
  double velocity = 0.1;  ///< V; granular temperature is scaled by V^2 [m/s]
  double time = 1e-2;     ///< V/g; momentum is scaled by density V/time, i.e. rho_s g [s]
  double density =
      2900;  ///< of the particles, or of the gas in scenes without particles; p_g is scaled by it times V^2
};

/// Where an unknown sits: at the centres of cells, or one component an axis at the lower faces of that axis.
enum class Place { cell, face };

/// Which part of the state the local error of a step counts an unknown in: nowhere; everywhere; where there are
/// particles, since its balance is multiplied by nu; in scenes where the gas alone can change.
enum class ErrorNorm { none, everywhere, with_particles, gas_alone };

/// Where a step of Newton's method may lead.
struct NewtonBounds {
  double lower = -std::numeric_limits<double>::infinity(), upper = std::numeric_limits<double>::infinity();
};

/// What bounds depend on beside the value.
struct NewtonContext {
  double nu_max = 0, chi_max = 0;
  bool first_guess = false;  ///< of a step in time, from where Newton's method seldom finds back up
};

inline NewtonBounds unbounded(double, const NewtonContext&) { return {}; }

/// The numbers that an option for an unknown accepts.
enum class Allowed { any, non_negative, positive, solids_fraction };

/// Whether and how a case gives values of an unknown; the key is the name of its dataset.
struct GivenValue {
  const char* text = nullptr;  ///< of the option; nullptr: there is none
  Allowed allowed = Allowed::any;
  double otherwise = 0;   ///< stored SI value where none is given
  bool required = false;  ///< inlets: has to be given
};

/// The trait of an unknown. Compared by address: one object an unknown.
struct Unknown {
  const char* dataset;  ///< name in files and of options, e.g. "solids_fraction"
  const char* symbol;   ///< as in MODEL.md
  const char* unit;     ///< SI
  const char* text;     ///< one line for readers of the file
  Place place;
  double (*scale)(const Scales&);                    ///< SI value of a stored 1
  double (*row_scale)(const Scales&, double rho_s);  ///< factor that makes the residual of its balance dimensionless
  ErrorNorm error;
  NewtonBounds (*bounds)(double value, const NewtonContext&);
  GivenValue initial;
  GivenValue inlet;
  /// Whether it acts on the other unknowns mostly in its own node, by sources or drag and not by what neighbours
  /// exchange: a solver may eliminate it there.
  bool acts_in_its_node = false;
};

/// One component of an unknown in the node of a scene's grid, for output, norms and probes. Cell-centred fields stand
/// alone; fields that share `dataset` and have face_axis 0, 1, 2 are the components of one vector.
struct Field {
  std::string dataset;  ///< name in files, e.g. "solids_fraction"; all components of a vector say "velocity"
  std::string symbol;   ///< as in MODEL.md
  std::string unit;     ///< SI
  std::string text;     ///< one line for readers of the file
  int component = 0;    ///< in the DMDA node
  int face_axis = -1;   ///< -1: at cell centres; else at the lower faces of that axis
  double scale = 1;     ///< SI value = scale * stored value
  const Unknown* unknown = nullptr;

  /// Whether this is (a component of) the unknown of that balance, e.g. is<SolidsContinuity>().
  template <class Balance>
  bool is() const {
    return unknown == &Balance::unknown;
  }
};

/// Name of a field as a column or a dataset of its own: "solids_fraction", "velocity_x", "velocity_y", ...
inline std::string column_name(const Field& field) {
  if (field.face_axis < 0) return field.dataset;
  return field.dataset + '_' + axis_name(field.face_axis);
}

}  // namespace scree

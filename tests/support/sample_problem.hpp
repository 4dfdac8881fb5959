/// Small scenes and reproducible states for tests of grid, balances and solver: built in a few lines, the same on any
/// number of ranks.
#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scree/balances/present.hpp"
#include "scree/stepping/discrete_problem.hpp"

namespace scree::test {

/// Throws, so that the test at hand fails.
inline void check(PetscErrorCode code) {
  if (code != 0) throw std::runtime_error("PETSc error " + std::to_string(code));
}

// ---- scenes ----

inline std::vector<double> uniform_faces(int cells, double width, double first = 0) {
  std::vector<double> faces;
  for (int i = 0; i <= cells; ++i) faces.push_back(first + i * width);
  return faces;
}

/// Cells that widen by `ratio` from one to the next.
inline std::vector<double> graded_faces(int cells, double width, double ratio) {
  std::vector<double> faces{0};
  for (int i = 0; i < cells; ++i, width *= ratio) faces.push_back(faces.back() + width);
  return faces;
}

inline Box graded_box(int dim, std::array<int, max_dim> cells, double width = 2e-3) {
  Box box;
  box.dim = dim;
  for (int axis = 0; axis < dim; ++axis) box.faces[axis] = graded_faces(cells[axis], width, 1.1 + 0.1 * axis);
  return box;
}

inline Box uniform_box(int dim, std::array<int, max_dim> cells, double width = 2e-3) {
  Box box;
  box.dim = dim;
  for (int axis = 0; axis < dim; ++axis) box.faces[axis] = uniform_faces(cells[axis], width);
  return box;
}

inline Condition condition(BoundaryKind kind, std::array<double, max_dim> velocity = {0, 0, 0}) {
  Condition result;
  result.kind = kind;
  result.velocity = velocity;
  return result;
}

/// The whole of one side.
inline Segment side(int axis, bool upper, const Condition& condition) {
  Segment segment;
  segment.condition = condition;
  segment.axis = axis;
  segment.upper = upper;
  return segment;
}

/// The same condition on all sides that are not periodic.
inline std::vector<Segment> all_sides(const Box& box, const Condition& condition) {
  std::vector<Segment> segments;
  for (int axis = 0; axis < box.dim; ++axis)
    for (const bool upper : {false, true})
      if (!box.periodic[axis]) segments.push_back(side(axis, upper, condition));
  return segments;
}

/// The diagonal of the rows of p_g that stands in the Jacobian alone; see assembled_model.hpp.
inline constexpr double pressure_hold = 1e-11;

inline void set_temperature_model(ProblemSetup& setup, TemperatureModel model, double value = 1e-4) {
  setup.model.temperature = setup.solids.temperature = model;
  setup.model.temperature_value = setup.solids.temperature_value = value;
}

/// Parameters of the paper's bin on `box`, in vacuum or in air.
inline ProblemSetup sample_setup(const Box& box, FrictionModel friction = FrictionModel::relaxed,
                                 TemperatureModel temperature = TemperatureModel::transport,
                                 AdvectionScheme advection = AdvectionScheme::upwind, GasModel gas = GasModel::none) {
  ProblemSetup setup;
  setup.box = box;
  setup.solids.gas.model = gas;
  setup.solids.friction.model = friction;
  set_temperature_model(setup, temperature);
  setup.model.advection = advection;
  setup.segments = all_sides(box, condition(BoundaryKind::wall_johnson_jackson));
  return setup;
}

// ---- states ----

/// A number in [-1, 1) that depends on its arguments only.
inline double noise(const Index& I, int component, int seed) {
  std::uint64_t x = 0x9E3779B97F4A7C15u * static_cast<std::uint64_t>(seed + 1);
  for (const int part : {I[0], I[1], I[2], component}) {
    x = (x ^ static_cast<std::uint64_t>(part + 1000)) * 0xBF58476D1CE4E5B9u;
    x ^= x >> 29;
  }
  x *= 0x94D049BB133111EBu;
  x ^= x >> 32;
  return static_cast<double>(x >> 11) * 0x1p-52 - 1;
}

/// Values of all unknowns at all nodes of the grid in natural order, the same on all ranks.
using Values = std::vector<double>;

/// A problem that can be evaluated at states in natural order.
class Evaluation {
 public:
  /// Residual and Jacobian are those at `time`.
  Evaluation(MPI_Comm comm, const ProblemSetup& setup, double time = 0) : comm_(comm), time_(time), problem_(setup) {
    check(problem_.create(comm, time));
    check(DMCreateGlobalVector(problem_.dm(), &state_));
    for (Vec* vector : {&rate_, &result_, &direction_}) check(VecDuplicate(state_, vector));
    for (int axis = 0; axis < max_dim; ++axis)
      if (axis < setup.box.dim) nodes_[axis] = setup.box.cells(axis) + (setup.box.periodic[axis] ? 0 : 1);
  }
  ~Evaluation() {
    for (Vec* vector : {&state_, &rate_, &result_, &direction_}) (void)VecDestroy(vector);
  }
  Evaluation(const Evaluation&) = delete;
  Evaluation& operator=(const Evaluation&) = delete;

  DiscreteProblem& problem() { return problem_; }
  double time() const { return time_; }
  const Lattice& lattice() const { return problem_.lattice(); }
  const std::vector<Field>& fields() const { return problem_.model().fields(); }
  int unknowns() const { return problem_.model().unknowns(); }
  const Index& nodes() const { return nodes_; }
  int size() const { return nodes_[0] * nodes_[1] * nodes_[2] * unknowns(); }
  /// Position in natural order; periodic axes wrap.
  int at(int component, const Index& I) const {
    Index wrapped = I;
    for (int axis = 0; axis < max_dim; ++axis) wrapped[axis] = (I[axis] + nodes_[axis]) % nodes_[axis];
    return ((wrapped[2] * nodes_[1] + wrapped[1]) * nodes_[0] + wrapped[0]) * unknowns() + component;
  }
  /// Component of the unknown with this symbol ("nu", "T", "chi", "u", ...), the first along the axes; -1 if absent.
  int component(const std::string& symbol) const {
    for (const Field& field : fields())
      if (field.symbol == symbol) return field.component;
    return -1;
  }

  /// Natural values from SI ones, value(field, I).
  template <class Value>
  Values values(Value&& value) const {
    Values result(static_cast<std::size_t>(size()), 0.0);
    for_each_node(Index{}, nodes_, [&](const Index& I) {
      for (const Field& field : fields()) result[at(field.component, I)] = value(field, I) / field.scale;
    });
    return result;
  }
  Values zeros() const { return Values(static_cast<std::size_t>(size()), 0.0); }

  void put(const Values& values, Vec vector) const {
    double* x;
    check(VecGetArray(vector, &x));
    each_owned([&](int owned, int natural) { x[owned] = values[static_cast<std::size_t>(natural)]; });
    check(VecRestoreArray(vector, &x));
  }
  Values get(Vec vector) const {
    Values result = zeros();
    const double* x;
    check(VecGetArrayRead(vector, &x));
    each_owned([&](int owned, int natural) { result[static_cast<std::size_t>(natural)] = x[owned]; });
    check(VecRestoreArrayRead(vector, &x));
    sum_over_ranks(result);
    return result;
  }
  void sum_over_ranks(Values& values) const {
    MPI_Allreduce(MPI_IN_PLACE, values.data(), size(), MPI_DOUBLE, MPI_SUM, comm_);
  }

  Values residual(const Values& state, const Values& rate) {
    put(state, state_);
    put(rate, rate_);
    check(problem_.residual(time_, state_, rate_, result_));
    return get(result_);
  }
  /// Assembles dF/dU + shift dF/d(dU/dt).
  void assemble(const Values& state, const Values& rate, double shift) {
    put(state, state_);
    put(rate, rate_);
    check(problem_.jacobian(time_, state_, rate_, shift, problem_.matrix()));
  }
  /// The assembled matrix times a direction.
  Values product(const Values& direction) {
    put(direction, direction_);
    check(MatMult(problem_.matrix(), direction_, result_));
    return get(result_);
  }
  /// Calls work(row, column, value) for each stored entry of the rows of this rank, in natural numbers.
  template <class Work>
  void each_entry(Work&& work) {
    AO order;
    PetscInt first, end;
    check(DMDAGetAO(problem_.dm(), &order));
    check(MatGetOwnershipRange(problem_.matrix(), &first, &end));
    for (PetscInt row = first; row < end; ++row) {
      PetscInt count;
      const PetscInt* columns;
      const double* entries;
      check(MatGetRow(problem_.matrix(), row, &count, &columns, &entries));
      std::vector<PetscInt> natural(columns, columns + count);
      natural.push_back(row);
      check(AOPetscToApplication(order, count + 1, natural.data()));
      for (PetscInt k = 0; k < count; ++k) work(natural.back(), natural[static_cast<std::size_t>(k)], entries[k]);
      check(MatRestoreRow(problem_.matrix(), row, &count, &columns, &entries));
    }
  }

  double outflow(const Values& state, Phase phase = Phase::solids) {
    double flux = 0;
    put(state, state_);
    check(problem_.outflow(time_, state_, phase, &flux));
    return flux;
  }

 private:
  template <class Work>
  void each_owned(Work&& work) const {
    const Lattice& grid = lattice();
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      for (int c = 0; c < unknowns(); ++c) work(grid.owned(I) * unknowns() + c, at(c, I));
    });
  }

  MPI_Comm comm_;
  double time_;
  DiscreteProblem problem_;
  Vec state_ = nullptr, rate_ = nullptr, result_ = nullptr, direction_ = nullptr;
  Index nodes_{{1, 1, 1}};
};

/// Where random states lie.
enum class Regime {
  dense,    ///< 0.52 < nu < 0.62
  dilute,   ///< nu = 1e-3 ... 0.4
  empty,    ///< nu = 1e-9 ... 1e-6
  surface,  ///< nu about 0.57 in every other cell along each axis, 1e-4 ... 1e-2 in the others
};

/// A random SI state of that regime, sqrt(T) about 0.01 m/s, velocities of both signs about 0.05 m/s; of the gas about
/// 0.2 m/s, and pressures that drive a gas without inertia through a dense bed at about 0.5 m/s.
inline double random_value(const Field& field, const Index& I, Regime regime, int seed) {
  const double z = noise(I, field.component, seed);
  if (field.symbol == "nu") {
    const bool filled = regime == Regime::dense || (regime == Regime::surface && (I[0] + I[1] + I[2]) % 2 == 0);
    if (filled) return 0.57 + 0.045 * z;
    if (regime == Regime::surface) return 1e-4 * std::pow(100.0, 0.5 + 0.5 * z);
    if (regime == Regime::dilute) return 1e-3 * std::pow(400.0, 0.5 + 0.5 * z);
    return 1e-9 * std::pow(1000.0, 0.5 + 0.5 * z);
  }
  if (field.symbol == "T") return 1e-4 * std::exp(1.5 * z);
  if (field.symbol == "chi") return 0.85 + 0.2 * z;
  if (field.symbol == "g_f") return 5 * std::exp(1.5 * z);
  if (field.symbol == "p_g") return 8 * z;
  return (field.symbol == "u" ? 0.2 : 0.05) * z;
}

/// By how much an unknown can vary, SI, until the residual shows curvature: for difference steps.
inline double random_scale(const Field& field, double value) {
  if (field.symbol == "nu") return value > 0.5 ? 0.02 : value;
  if (field.symbol == "T" || field.symbol == "g_f") return value;
  if (field.symbol == "chi") return 0.01;
  if (field.symbol == "p_g") return 0.5;
  return field.symbol == "u" ? 0.012 : 3e-3;
}

}  // namespace scree::test

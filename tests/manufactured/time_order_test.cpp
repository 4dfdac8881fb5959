/// Order of accuracy in time of each scheme, for differential and algebraic unknowns (T19): the steps are those of the
/// program, corrections of nu and u included. The source is the discrete residual of the exact fields, so that there is
/// no error in space.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>

#include "../support/sample_problem.hpp"
#include "exact_fields.hpp"
#include "order_table.hpp"
#include "scree/stepping/time_stepper.hpp"

namespace scree::test {
namespace {

constexpr double length = 0.02, end = 4e-3;  // of the box [m], of the run [s]

struct TimeCase {
  TimeScheme scheme;
  int dim;
  GasModel gas;
  double order;           ///< of differential unknowns
  double pressure_order;  ///< of p_g
};

/// A problem whose exact solution in time is given at the nodes of the grid.
class MovingProblem {
 public:
  MovingProblem(const ProblemSetup& setup, const ExactFields& exact, TimeScheme scheme, double dt)
      : exact_(exact), problem_(setup) {
    check(problem_.create(PETSC_COMM_WORLD, 0));
    StepControl control;
    control.scheme = scheme;
    control.step.initial = dt;
    const double order = Scheme(scheme).order();
    control.accuracy = std::pow(1e-8, order / (order + 1));  // of local errors of 1e-8: Newton's tolerance goes with it
    control.step.adaptive = false;
    check(PetscOptionsSetValue(nullptr, "-ksp_type", "preonly"));
    check(PetscOptionsSetValue(nullptr, "-pc_type", "lu"));
    stepper_ = std::make_unique<TimeStepper>(problem_, control);
    check(stepper_->create(0));
    for (Vec* vector : {&values_, &rates_, &source_}) check(VecDuplicate(stepper_->state(), vector));
    put_exact(0, stepper_->state());
    check(TSGetIFunction(stepper_->ts(), nullptr, &residual_, &context_));
    check(TSSetIFunction(stepper_->ts(), nullptr, with_source, this));
  }
  ~MovingProblem() {
    for (Vec* vector : {&values_, &rates_, &source_}) (void)VecDestroy(vector);
  }
  MovingProblem(const MovingProblem&) = delete;
  MovingProblem& operator=(const MovingProblem&) = delete;

  /// Steps to the end; greatest errors there by the symbol of the unknown, in units of its scale.
  std::map<std::string, double> errors_at_end() {
    while (stepper_->time() < end * (1 - 1e-9)) {
      StepReport report;
      check(stepper_->step(end, &report));
      if (report.failed) throw std::runtime_error("a step failed: " + report.reason);
    }
    put_exact(end, values_);
    check(VecAXPY(values_, -1, stepper_->state()));
    std::map<std::string, double> errors;
    for (const Field& field : problem_.model().fields()) {
      double norm;
      check(VecStrideNorm(values_, field.component, NORM_INFINITY, &norm));
      errors[field.symbol] = std::max(errors[field.symbol], norm);
    }
    return errors;
  }

 private:
  static PetscErrorCode with_source(TS ts, double time, Vec state, Vec rate, Vec residual, void* self) {
    PetscFunctionBeginUser;
    auto& p = *static_cast<MovingProblem*>(self);
    p.put_exact(time, p.values_);
    p.put_rates(time, p.rates_);
    PetscCall(p.residual_(ts, time, p.values_, p.rates_, p.source_, p.context_));
    PetscCall(p.residual_(ts, time, state, rate, residual, p.context_));
    PetscCall(VecAXPY(residual, -1, p.source_));
    PetscFunctionReturn(0);
  }
  /// The exact fields, u made such that div(nu v + (1-nu) u) = 0 on the grid, as that of the program is.
  void put_exact(double time, Vec state) {
    const Lattice& grid = problem_.lattice();
    const Model& model = problem_.model();
    double* x;
    check(VecZeroEntries(state));
    check(VecGetArray(state, &x));
    for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
      for (const Field& field : model.fields()) {
        if (field.face_axis < 0 ? !grid.inside(I) : !grid.is_face(field.face_axis, I)) continue;
        std::array<double, max_dim> place{};
        for (int a = 0; a < grid.dim; ++a)
          place[a] = field.face_axis == a ? grid.axes[a].face(I[a]) : grid.axes[a].centre(I[a]);
        x[grid.owned(I) * model.unknowns() + field.component] =
            exact_.at(place, time).value(field.symbol, field.face_axis) / field.scale;
      }
    });
    check(VecRestoreArray(state, &x));
    check(impose_gas(problem_, time, state));
    check(project_gas(problem_, time, state));
  }

  /// Their time derivatives, by differences of sixth order.
  void put_rates(double time, Vec rates) {
    constexpr double h = 1e-4;
    check(VecZeroEntries(rates));
    const double weights[3] = {3. / 4, -3. / 20, 1. / 60};
    for (int k = 1; k <= 3; ++k)
      for (const int side : {-1, 1}) {
        put_exact(time + side * k * h, source_);
        check(VecAXPY(rates, side * weights[k - 1] / h, source_));
      }
  }

  ExactFields exact_;
  DiscreteProblem problem_;
  std::unique_ptr<TimeStepper> stepper_;
  TSIFunction residual_ = nullptr;  ///< of the program
  void* context_ = nullptr;
  Vec values_ = nullptr, rates_ = nullptr, source_ = nullptr;
};

class TimeOrder : public testing::TestWithParam<TimeCase> {};

TEST_P(TimeOrder, EachUnknown) {
  const TimeCase& c = GetParam();
  ExactFields exact;
  exact.dim = c.dim;
  exact.length = length;
  exact.moving_in_time = true;
  const int cells = c.dim == 1 ? 16 : 6;
  const Box box = uniform_box(c.dim, {cells, cells, cells}, length / cells);
  ProblemSetup setup =
      sample_setup(box, FrictionModel::relaxed, TemperatureModel::transport, AdvectionScheme::upwind, c.gas);
  setup.segments = all_sides(box, condition(BoundaryKind::wall_free_slip));  // laws of slip make this flow unstable
  setup.segments.push_back(side(c.dim - 1, true, condition(BoundaryKind::open)));
  setup.solids.friction.tau = 1e-2;

  const std::vector<double> steps{10, 20, 40, 80};
  std::map<std::string, std::vector<double>> errors;
  for (const double count : steps) {
    MovingProblem problem(setup, exact, c.scheme, end / count);
    for (const auto& [symbol, error] : problem.errors_at_end()) errors[symbol].push_back(error);
  }
  for (const auto& [symbol, error] : errors) {
    const double expected = symbol == "p_g" ? c.pressure_order : c.order;
    OrderRow row{name_of(c.scheme) + std::string(", ") + std::to_string(c.dim) + "-D, " + gas_name(c.gas),
                 symbol,
                 error,
                 error,
                 .95 * expected,
                 steps,
                 "steps"};
    EXPECT_GE(OrderTable::add(row), row.bound) << row.name << ": " << symbol;
  }
}

std::vector<TimeCase> time_cases() {
  std::vector<TimeCase> cases;
  for (const int dim : {1, 2})
    for (const GasModel gas : {GasModel::none, GasModel::darcy, GasModel::incompressible}) {
      cases.push_back({TimeScheme::beuler, dim, gas, 1, 1});
      cases.push_back({TimeScheme::bdf, dim, gas, 2, 2});
      cases.push_back({TimeScheme::arkimex, dim, gas, 2, 2});
    }
  return cases;
}

std::string test_name(const testing::TestParamInfo<TimeCase>& info) {
  return name_of(info.param.scheme) + std::string("_") + std::to_string(info.param.dim) + "D_" +
         std::array<const char*, 3>{"none", "darcy", "incompressible"}[static_cast<std::size_t>(info.param.gas)];
}

INSTANTIATE_TEST_SUITE_P(, TimeOrder, testing::ValuesIn(time_cases()), test_name);

}  // namespace
}  // namespace scree::test

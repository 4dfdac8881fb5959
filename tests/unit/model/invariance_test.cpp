/// T20: the same scene seen otherwise has the same residual.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "../../jacobian/scenes.hpp"

namespace scree::test {
namespace {

std::vector<Combination> chosen(int dim) {
  std::vector<Combination> result;
  for (const auto friction : {FrictionModel::relaxed, FrictionModel::instantaneous})
    for (const auto advection : {AdvectionScheme::upwind, AdvectionScheme::van_albada})
      for (const auto gas : {GasModel::none, GasModel::darcy, GasModel::incompressible})
        if (gas == GasModel::none || friction == FrictionModel::relaxed)
          result.push_back({dim, friction, TemperatureModel::transport, advection, gas});
  return result;
}

Values random_state(const Evaluation& problem, int seed) {
  return problem.values([&](const Field& f, const Index& I) { return random_value(f, I, Regime::dense, seed); });
}
Values random_rate(const Evaluation& problem, int seed) {
  return problem.values([&](const Field& f, const Index& I) { return 5 * f.scale * noise(I, f.component, seed); });
}

/// How an unknown of one problem appears in another: its place there, and a factor; component -1: not there.
struct Image {
  int component;
  Index at;
  double factor = 1;
};
using Map = std::function<Image(const Evaluation&, const Field&, const Index&)>;

/// Whether an unknown exists at node I: padding does not.
bool exists(const Evaluation& problem, const Field& field, const Index& I) {
  return field.face_axis < 0 ? problem.lattice().inside(I) : problem.lattice().is_face(field.face_axis, I);
}

/// Carries values over; the rest of the target is zero.
Values image(const Evaluation& from, const Values& values, const Evaluation& to, const Map& map) {
  Values result = to.zeros();
  for_each_node(Index{}, from.nodes(), [&](const Index& I) {
    for (const Field& field : from.fields()) {
      if (!exists(from, field, I)) continue;
      const Image there = map(from, field, I);
      result[to.at(there.component, there.at)] = there.factor * values[from.at(field.component, I)];
    }
  });
  return result;
}

/// Residual, then map, against map, then residual; 1e-11 of the largest row: sums in another order, cancelling
/// stresses.
void expect_same(const ProblemSetup& original, const ProblemSetup& mapped, const Map& map) {
  Evaluation here(PETSC_COMM_SELF, original), there(PETSC_COMM_SELF, mapped);
  const Values state = random_state(here, 1), rate = random_rate(here, 2);
  const Values residual = here.residual(state, rate);
  const Values other = there.residual(image(here, state, there, map), image(here, rate, there, map));
  std::vector<double> scale(static_cast<std::size_t>(here.unknowns()), 0.0);
  for (int i = 0; i < here.size(); ++i)
    scale[i % here.unknowns()] = std::max(scale[i % here.unknowns()], std::abs(residual[i]));
  for_each_node(Index{}, here.nodes(), [&](const Index& I) {
    for (const Field& field : here.fields()) {
      if (!exists(here, field, I)) continue;
      const Image image_of = map(here, field, I);
      EXPECT_NEAR(other[there.at(image_of.component, image_of.at)],
                  image_of.factor * residual[here.at(field.component, I)], 1e-11 * scale[field.component])
          << column_name(field) << " (" << I[0] << ", " << I[1] << ", " << I[2] << ')';
    }
  });
}

// ---- mirror ----

ProblemSetup mirrored(ProblemSetup setup, int axis) {
  const std::vector<double> old = setup.box.faces[axis];
  auto& faces = setup.box.faces[axis];
  for (std::size_t i = 0; i < faces.size(); ++i) faces[i] = old.front() + old.back() - old[old.size() - 1 - i];
  const auto turn = [&](Patch& patch) {
    const double lower = patch.lower[axis], sum = old.front() + old.back();
    patch.lower[axis] = sum - patch.upper[axis];
    patch.upper[axis] = sum - lower;
  };
  for (Segment& segment : setup.segments) {
    segment.condition.velocity[axis] *= -1;
    Ramp& profile = segment.condition.gas_variation.profile;
    if (segment.condition.gas_variation.axis == axis) {
      for (double& x : profile.at) x = old.front() + old.back() - x;
      std::reverse(profile.at.begin(), profile.at.end());
      std::reverse(profile.factor.begin(), profile.factor.end());
    }
    if (segment.axis == axis)
      segment.upper = !segment.upper;
    else
      turn(segment.patch);
  }
  for (Plate& plate : setup.plates) {
    plate.condition.velocity[axis] *= -1;
    if (plate.axis == axis) plate.position = old.front() + old.back() - plate.position;
    turn(plate.span);
    for (Patch& opening : plate.openings) turn(opening);
  }
  setup.model.gravity[axis] *= -1;
  return setup;
}

TEST(Invariance, MirroredSceneHasTheMirroredResidual) {
  for (int dim = 1; dim <= 3; ++dim)
    for (const Combination& c : chosen(dim))
      for (const NamedScene& scene : all_scenes(sample_setup(c)))
        for (int axis = 0; axis < dim; ++axis) {
          SCOPED_TRACE(name_of(c) + ", " + scene.name + ", mirrored in " + "xyz"[axis]);
          expect_same(
              scene.setup, mirrored(scene.setup, axis), [&](const Evaluation& e, const Field& f, const Index& I) {
                Image result{f.component, I, f.face_axis == axis ? -1.0 : 1.0};
                const int cells = e.lattice().axes[axis].cells();
                result.at[axis] = f.face_axis == axis ? (e.lattice().axes[axis].periodic() ? (cells - I[axis]) % cells
                                                                                           : cells - I[axis])
                                                      : cells - 1 - I[axis];
                return result;
              });
        }
}

// ---- rotation of the axes ----

template <class T>
std::array<T, max_dim> turned(const std::array<T, max_dim>& a, int dim) {
  std::array<T, max_dim> b{};
  for (int axis = 0; axis < max_dim; ++axis) b[axis < dim ? (axis + 1) % dim : axis] = a[axis];
  return b;
}
Patch turned(const Patch& patch, int dim) {
  Patch result;
  result.lower = turned(patch.lower, dim);
  result.upper = turned(patch.upper, dim);
  return result;
}

/// x becomes y, y becomes z, ...
ProblemSetup turned(ProblemSetup setup) {
  const int dim = setup.box.dim;
  setup.box.faces = turned(setup.box.faces, dim);
  setup.box.periodic = turned(setup.box.periodic, dim);
  setup.model.gravity = turned(setup.model.gravity, dim);
  for (Segment& segment : setup.segments) {
    segment.axis = (segment.axis + 1) % dim;
    segment.patch = turned(segment.patch, dim);
    segment.condition.velocity = turned(segment.condition.velocity, dim);
    segment.condition.gas_variation.axis = (segment.condition.gas_variation.axis + 1) % dim;
  }
  for (Plate& plate : setup.plates) {
    plate.axis = (plate.axis + 1) % dim;
    plate.span = turned(plate.span, dim);
    for (Patch& opening : plate.openings) opening = turned(opening, dim);
    plate.condition.velocity = turned(plate.condition.velocity, dim);
  }
  return setup;
}

TEST(Invariance, AxesAreEqual) {
  for (int dim = 2; dim <= 3; ++dim)
    for (const Combination& c : chosen(dim))
      for (const NamedScene& scene : all_scenes(sample_setup(c))) {
        SCOPED_TRACE(name_of(c) + ", " + scene.name);
        expect_same(scene.setup, turned(scene.setup), [&](const Evaluation&, const Field& f, const Index& I) {
          Image result{f.component, Index{turned(I.at, dim)}};
          if (f.face_axis >= 0) result.component += (f.face_axis + 1) % dim - f.face_axis;
          return result;
        });
      }
}

// ---- a periodic axis has no beginning ----

TEST(Invariance, PeriodicSceneMayBeginAnywhere) {
  for (const Combination& c : chosen(2)) {
    ProblemSetup setup = sample_setup(c);
    setup.box = uniform_box(2, {6, 4, 0});
    setup.box.periodic = {true, false, false};
    setup.segments = all_sides(setup.box, condition(BoundaryKind::wall_johnson_jackson));
    for (const bool plate : {false, true}) {
      for (int shift = 1; shift <= 4; ++shift) {
        setup.plates.clear();
        if (plate) setup.plates.push_back(sample_plate(setup.box, 0, condition(BoundaryKind::wall_johnson_jackson)));
        for (Plate& p : setup.plates) p.position = setup.box.faces[0][1];
        ProblemSetup shifted = setup;
        for (Plate& p : shifted.plates) p.position = setup.box.faces[0][static_cast<std::size_t>(1 + shift)];
        SCOPED_TRACE(name_of(c) + (plate ? ", with a plate across the axis" : "") + ", shifted by " +
                     std::to_string(shift) + " cells");
        expect_same(setup, shifted, [&](const Evaluation&, const Field& f, const Index& I) {
          return Image{f.component, I + shift * unit(0)};
        });
      }
    }
  }
}

// ---- thin scenes ----

/// One cell between frictionless sides, or three periodic ones, add nothing to a scene of one dimension less.
TEST(Invariance, ThinSceneIsTheSceneOfLowerDimension) {
  for (int dim = 1; dim <= 2; ++dim)
    for (const Combination& c : chosen(dim))
      for (const NamedScene& scene : mixed_scenes(sample_setup(c)))
        for (const auto kind : {BoundaryKind::symmetry, BoundaryKind::wall_free_slip}) {
          ProblemSetup thin = scene.setup;
          thin.box.dim = dim + 1;
          thin.box.faces[dim] = {0, 3e-3};
          thin.box.periodic[dim] = false;
          for (const bool upper : {false, true}) thin.segments.push_back(side(dim, upper, condition(kind)));
          for (Segment& segment : thin.segments) {
            if (segment.axis < dim) segment.condition.velocity[dim] = 0;
            if (segment.condition.gas_variation.axis == dim) segment.condition.gas_variation.axis = 0;
          }
          for (Plate& plate : thin.plates) plate.condition.velocity[dim] = 0;
          SCOPED_TRACE(name_of(c) + ", " + scene.name + ", between sides of kind " + std::string(kind.name));
          ProblemSetup plain = thin;  // moving walls drag out of the plane: not here
          plain.box = scene.setup.box;
          plain.segments.resize(plain.segments.size() - 2);
          expect_same(plain, thin, [&](const Evaluation& e, const Field& f, const Index& I) {
            const bool behind_v = f.component > dim, behind_u = e.component("u") >= 0 && f.component > 2 * dim;
            return Image{f.component + behind_v + behind_u, I};
          });
        }
}

// ---- moving observer ----

/// Residual of a state that is uniform along the periodic x axis, with `wind` added to v_x, u_x and to the walls.
Values seen_from(ProblemSetup setup, double wind) {
  for (Segment& segment : setup.segments) segment.condition.velocity[0] += wind;
  Evaluation problem(PETSC_COMM_SELF, setup);
  const int rows = setup.box.cells(1);
  const Values state = problem.values([&](const Field& f, const Index& I) {
    if (f.face_axis == 1 && (I[1] == 0 || I[1] == rows)) return 0.0;
    const bool moves = f.face_axis == 0 && I[1] < rows;
    return random_value(f, Index{{0, I[1], 0}}, Regime::dense, 3) + (moves ? wind : 0.0);
  });
  return problem.residual(state, problem.zeros());
}

/// What is uniform along a periodic axis does not know how fast it moves that way; not even in a gap of one cell.
TEST(Invariance, ConstantVelocityAlongAUniformAxisChangesNothing) {
  for (const Combination& c : chosen(2))
    for (const auto kind : {BoundaryKind::wall_johnson_jackson, BoundaryKind::wall_no_slip})
      for (const int rows : {1, 4}) {
        ProblemSetup setup = sample_setup(c);
        setup.box = graded_box(2, {6, rows, 0});
        setup.box.faces[0] = uniform_faces(6, 2e-3);
        setup.box.periodic = {true, false, false};
        setup.segments = all_sides(setup.box, sticky(condition(kind, {0.02, 0, 0})));
        setup.model.gas_viscous_stress = true;
        setup.model.solids_fraction_floor = 0;  // its drag is towards rest
        const Values still = seen_from(setup, 0), moving = seen_from(setup, 0.3);
        double scale = 0;
        for (const double f : still) scale = std::max(scale, std::abs(f));
        SCOPED_TRACE(name_of(c) + ", walls of kind " + std::string(kind.name) + ", " + std::to_string(rows) +
                     " cells between them");
        for (std::size_t i = 0; i < still.size(); ++i) EXPECT_NEAR(moving[i], still[i], 1e-11 * scale) << "row " << i;
      }
}

}  // namespace
}  // namespace scree::test

#include "scree/app/initial_run.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "scree/balances/solids_continuity.hpp"
#include "scree/config/input_error.hpp"
#include "scree/config/quantity.hpp"

namespace scree {

namespace {

constexpr double same_place = 1e-9;  ///< of the box: ends that differ by rounding are the same

std::string key_of(const InitialRegion& region) { return "initial_" + region.name + "_run"; }

std::string extent_text(const Box& box, int axis) {
  return axis_name(axis) + " from " + number_text(box.lower(axis)) + " to " + number_text(box.upper(axis)) + " m";
}

/// The region is to lie in the box of the run that fills it.
void check_fit(const Case& the_case, const InitialRegion& region, const Box& box) {
  const auto wrong = [&](const std::string& expected) { return InputError(key_of(region), region.run, expected); };
  if (box.dim != the_case.box.dim)
    throw wrong("a run in " + std::to_string(the_case.box.dim) + " dimensions, as this case; that one has " +
                std::to_string(box.dim));
  for (int axis = 0; axis < box.dim; ++axis) {
    const double slack = same_place * (box.upper(axis) - box.lower(axis));
    if (region.lower[axis] >= box.lower(axis) - slack && region.upper[axis] <= box.upper(axis) + slack) continue;
    throw wrong("a run whose box holds the region, which has " + axis_name(axis) + " from " +
                number_text(region.lower[axis]) + " to " + number_text(region.upper[axis]) + " m; that one has " +
                extent_text(box, axis) + " (initial_" + region.name + "_box bounds the region)");
  }
}

/// As an error of the key that names the run. All ranks alike.
SavedState read_run(MPI_Comm comm, const InitialRegion& region, const std::function<NodeBlock(const Box&)>& wanted) {
  try {
    return read_state(comm, region.run, wanted);
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw InputError(key_of(region), region.run,
                     std::string("the output directory of a run of Scree; ") + error.what());
  }
}

/// The nodes from the least to the greatest that were asked for along an axis.
class Span {
 public:
  void add(const std::vector<TransferPart>& parts) {
    for (const TransferPart& part : parts) {
      least_ = std::min(least_, part.at);
      greatest_ = std::max(greatest_, part.at);
    }
  }
  /// With one more at each end, for slopes; the whole axis where that leads round it.
  void put_into(const Box& box, int axis, NodeBlock& block) const {
    const int nodes = nodes_of(box)[axis];
    const bool round = box.periodic[axis] && (least_ < 1 || greatest_ > nodes - 2);
    const int first = round ? 0 : std::max(least_ - 1, 0),
              last = round ? nodes - 1 : std::min(greatest_ + 1, nodes - 1);
    block.first[axis] = least_ > greatest_ ? 0 : first;
    block.count[axis] = least_ > greatest_ ? 0 : last - first + 1;
  }

 private:
  int least_ = 1 << 30, greatest_ = -1;
};

}  // namespace

InitialRun::InitialRun(MPI_Comm comm, const Case& the_case, const InitialRegion& region, const Lattice& grid)
    : region_(region), saved_(read_run(comm, region, [&](const Box& box) {
        check_fit(the_case, region, box);
        return wanted(grid, box);
      })) {}

/// Those that the owned nodes in the region take from.
NodeBlock InitialRun::wanted(const Lattice& grid, const Box& box) const {
  NodeBlock block;
  for (int axis = 0; axis < grid.dim; ++axis) {
    Span span;
    const Axis& along = grid.axes[axis];
    const auto in_region = [&](double x) { return x >= region_.lower[axis] && x <= region_.upper[axis]; };
    for (int i = grid.owned_first[axis]; i < grid.owned_first[axis] + grid.owned_count[axis]; ++i) {
      if (in_region(along.face(i))) span.add(face_parts(box.faces[axis], along.face(i)));
      if (i < along.cells() && in_region(along.centre(i)))
        span.add(cell_parts(box.faces[axis], along.face(i), along.face(i + 1)));
    }
    span.put_into(box, axis, block);
  }
  return block;
}

double InitialRun::value(const Lattice& grid, const Field& field, const Index& I) const {
  const Field& source = *saved_.find(field.dataset, field.face_axis);
  std::array<double, max_dim> lower{}, upper{};
  for (int a = 0; a < grid.dim; ++a) {
    lower[a] = grid.axes[a].face(I[a]);
    upper[a] = grid.axes[a].face(I[a] + 1);
  }
  const Transfer transfer(saved_.box);
  const Transfer::Parts parts = transfer.parts(lower, upper, field.face_axis);
  const auto values = [&](const Index& place) { return saved_.value(source, place); };
  if (field.unknown->error != ErrorNorm::with_particles) return transfer.mean(parts, field.face_axis, values);
  return transfer.mean(parts, field.face_axis, values,
                       [&](const Index& place) { return particles_at(field.face_axis, place); });
}

/// nu at a cell or face of the run, with a little in voids: where there are no particles all parts count alike.
double InitialRun::particles_at(int face_axis, const Index& place) const {
  constexpr double in_voids = 1e-10;
  const Field& nu = *saved_.find(SolidsContinuity::unknown.dataset, -1);
  if (face_axis < 0) return std::max(saved_.value(nu, place), 0.0) + in_voids;
  const Box& box = saved_.box;
  const bool periodic = box.periodic[face_axis];
  const Index below = place - unit(face_axis);
  const double lower = periodic || place[face_axis] > 0 ? saved_.value(nu, below) : 0;
  const double upper = periodic || place[face_axis] < box.cells(face_axis) ? saved_.value(nu, place) : 0;
  return std::max(lower + upper, 0.0) + in_voids;
}

std::string InitialRun::remark(const std::vector<Field>& fields) const {
  std::string missing;
  for (const Field& field : fields)
    if (!has(field)) missing += (missing.empty() ? "" : ", ") + column_name(field);
  return (saved_.remark.empty() ? "" : saved_.remark + "; ") + "initial " + region_.name + ": from " + saved_.file +
         " at t = " + number_text(saved_.time) + " s" +
         (missing.empty() ? "" : "; it has no " + missing + ", which starts as elsewhere");
}

void check_initial_runs(MPI_Comm comm, const Case& the_case) {
  for (const InitialRegion& region : the_case.initial) {
    if (region.run.empty()) continue;
    (void)read_run(comm, region, [&](const Box& box) {
      check_fit(the_case, region, box);
      return NodeBlock{{}, {{0, 0, 0}}};
    });
  }
}

}  // namespace scree

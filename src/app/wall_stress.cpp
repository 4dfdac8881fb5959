#include "scree/app/wall_stress.hpp"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "scree/grid/ghosted.hpp"
#include "scree/output/atomic_file.hpp"
#include "scree/output/errors.hpp"

namespace scree {

namespace {

MPI_Comm comm_of(const DiscreteProblem& problem) {
  return PetscObjectComm(reinterpret_cast<PetscObject>(problem.dm()));
}

/// The numbers of a line of the file, behind those by which lines are sorted.
using Row = std::vector<double>;
constexpr std::size_t keys = 2 + max_dim;  ///< wall, places along the axes from the last, side of the particles

double normal_sign(const WallFace& face) { return face.cells == End::upper ? 1 : -1; }

void add_stresses(const WallFace& face, const std::array<double, max_dim>& traction, int dim, Row& row) {
  row.push_back(-normal_sign(face) * traction[static_cast<std::size_t>(face.axis)]);
  for (int a = 0; a < dim; ++a) row.push_back(a == face.axis ? 0 : traction[static_cast<std::size_t>(a)]);
}

Row row_of(const WallFace& face, const Lattice& grid, const WallAverage* average) {
  Row row{static_cast<double>(face.wall)};
  std::array<double, max_dim> centre{};
  for (int a = 0; a < grid.dim; ++a)
    centre[a] = a == face.axis ? grid.axes[a].face(face.I[a]) : grid.axes[a].centre(face.I[a]);
  for (int a = max_dim - 1; a >= 0; --a) row.push_back(centre[a]);
  row.push_back(normal_sign(face));
  for (int a = 0; a < grid.dim; ++a) row.push_back(centre[a]);
  for (int a = 0; a < grid.dim; ++a) row.push_back(a == face.axis ? normal_sign(face) : 0);
  row.push_back(grid.face_area(face.axis, face.I));
  add_stresses(face, face.traction, grid.dim, row);
  if (average) add_stresses(face, average->mean(face), grid.dim, row);
  return row;
}

std::string header(int dim, bool with_mean) {
  std::string text = "time";
  const auto vector = [&](const std::string& name) {
    for (int a = 0; a < dim; ++a) text += "," + name + axis_name(a);
  };
  vector("");
  vector("normal_");
  text += ",area";
  for (const std::string& prefix : {std::string(), std::string("mean_")}) {
    if (!prefix.empty() && !with_mean) continue;
    text += "," + prefix + "normal_stress";
    vector(prefix + "shear_stress_");
  }
  return text + "\n";
}

/// All rows on rank 0, sorted; none elsewhere.
std::vector<Row> gathered(MPI_Comm comm, const std::vector<Row>& mine, std::size_t width) {
  int rank, ranks, count = static_cast<int>(mine.size() * width);
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  std::vector<double> numbers;
  for (const Row& row : mine) numbers.insert(numbers.end(), row.begin(), row.end());
  std::vector<int> counts(static_cast<std::size_t>(ranks)), starts(static_cast<std::size_t>(ranks));
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, comm);
  for (std::size_t r = 1; r < counts.size(); ++r) starts[r] = starts[r - 1] + counts[r - 1];
  std::vector<double> all(rank == 0 ? static_cast<std::size_t>(starts.back() + counts.back()) : 0);
  MPI_Gatherv(numbers.data(), count, MPI_DOUBLE, all.data(), counts.data(), starts.data(), MPI_DOUBLE, 0, comm);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < all.size(); i += width)
    rows.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(i),
                      all.begin() + static_cast<std::ptrdiff_t>(i + width));
  std::sort(rows.begin(), rows.end());
  return rows;
}

}  // namespace

WallStress::WallStress(const Case& the_case, const DiscreteProblem& problem) : problem_(problem) {
  const auto add = [&](const std::string& name, bool holds) {
    if (holds) names_.push_back(name);
  };
  for (const Segment& segment : the_case.segments)
    add("boundary_" + segment.condition.name, segment.condition.kind.stops_solids());
  for (const Plate& plate : the_case.plates) add("plate_" + plate.condition.name, true);
}

/// Of the lower `axis` face of I; -1: none.
int WallStress::wall(int axis, const Index& I) const {
  const Barriers& barriers = problem_.barriers();
  if (!problem_.lattice().is_face(axis, I) || !barriers.wall(axis, I)) return -1;
  const bool side = problem_.lattice().on_side(axis, I);
  const auto found =
      std::find(names_.begin(), names_.end(), (side ? "boundary_" : "plate_") + barriers.condition(axis, I).name);
  return found == names_.end() ? -1 : static_cast<int>(found - names_.begin());
}

std::vector<WallFace> WallStress::faces(double time, Vec state) const {
  const Lattice& grid = problem_.lattice();
  std::vector<WallFace> faces;
  GhostedArray u;
  check_petsc(u.open(problem_.dm(), state), "stresses on walls");
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    for (int axis = 0; axis < grid.dim; ++axis) {
      const int number = wall(axis, I);
      if (number < 0) continue;
      for (const End cells : {End::upper, End::lower}) {
        if (!grid.inside(cells == End::upper ? I : I - unit(axis))) continue;
        faces.push_back({number, axis, I, cells, problem_.model().wall_traction(time, u.data(), axis, I, cells)});
      }
    }
  });
  check_petsc(u.close(), "stresses on walls");
  return faces;
}

std::vector<std::array<double, max_dim>> WallStress::forces(double time, Vec state) const {
  std::vector<std::array<double, max_dim>> sums(names_.size(), {0, 0, 0});
  for (const WallFace& face : faces(time, state)) {
    const double area = problem_.lattice().face_area(face.axis, face.I);
    for (int a = 0; a < max_dim; ++a) sums[static_cast<std::size_t>(face.wall)][a] += area * face.traction[a];
  }
  MPI_Allreduce(MPI_IN_PLACE, sums.data(), static_cast<int>(max_dim * sums.size()), MPI_DOUBLE, MPI_SUM,
                comm_of(problem_));
  return sums;
}

WallAverage::WallAverage(const DiscreteProblem& problem, double from)
    : problem_(problem), from_(from), sums_(2 * static_cast<std::size_t>(problem.box().dim), nullptr) {
  for (Vec& sum : sums_) check_petsc(DMCreateGlobalVector(problem.dm(), &sum), "mean stresses on walls");
}

WallAverage::~WallAverage() {
  for (Vec& sum : sums_) (void)VecDestroy(&sum);
}

void WallAverage::add(double time, double dt, const std::vector<WallFace>& faces) {
  const double counted = std::min(dt, time - from_);
  if (counted <= 0) return;
  seconds_ += counted;
  const Lattice& grid = problem_.lattice();
  for (std::size_t k = 0; k < sums_.size(); ++k) {
    double* sum;
    check_petsc(VecGetArray(sums_[k], &sum), "mean stresses on walls");
    for (const WallFace& face : faces)
      for (int a = 0; a < grid.dim && place(face) == k; ++a)
        sum[grid.owned(face.I) * problem_.model().unknowns() + a] += counted * face.traction[a];
    check_petsc(VecRestoreArray(sums_[k], &sum), "mean stresses on walls");
  }
}

std::array<double, max_dim> WallAverage::mean(const WallFace& face) const {
  const Lattice& grid = problem_.lattice();
  std::array<double, max_dim> mean{0, 0, 0};
  const double* sum;
  check_petsc(VecGetArrayRead(sums_[place(face)], &sum), "mean stresses on walls");
  for (int a = 0; a < grid.dim; ++a) mean[a] = sum[grid.owned(face.I) * problem_.model().unknowns() + a] / seconds_;
  check_petsc(VecRestoreArrayRead(sums_[place(face)], &sum), "mean stresses on walls");
  return mean;
}

std::vector<std::pair<std::string, Vec>> WallAverage::sums() const {
  std::vector<std::pair<std::string, Vec>> list;
  for (std::size_t k = 0; k < sums_.size(); ++k)
    list.push_back({"wall_" + axis_name(static_cast<int>(k / 2)) + (k % 2 == 0 ? "_above" : "_below"), sums_[k]});
  return list;
}

void write_wall_stress(const std::string& directory, int index, double time, Vec state, const WallStress& walls,
                       const WallAverage* average, const DiscreteProblem& problem) {
  const Lattice& grid = problem.lattice();
  const std::size_t columns =
      2UL * static_cast<std::size_t>(grid.dim) + 1 + (average ? 2UL : 1UL) * (1UL + static_cast<std::size_t>(grid.dim));
  std::vector<Row> mine;
  for (const WallFace& face : walls.faces(time, state)) mine.push_back(row_of(face, grid, average));
  const std::vector<Row> rows = gathered(comm_of(problem), mine, keys + columns);
  on_first_rank(comm_of(problem), [&] {
    if (!rows.empty()) std::filesystem::create_directories(directory + "/walls");
    for (std::size_t first = 0; first < rows.size();) {
      std::string text = header(grid.dim, average != nullptr);
      char number[40];
      std::size_t row = first;
      for (; row < rows.size() && rows[row][0] == rows[first][0]; ++row) {
        std::snprintf(number, sizeof number, "%.15g", time);
        text += number;
        for (std::size_t k = keys; k < rows[row].size(); ++k) {
          std::snprintf(number, sizeof number, ",%.10g", rows[row][k]);
          text += number;
        }
        text += '\n';
      }
      std::snprintf(number, sizeof number, "_%06d.csv", index);
      write_text_atomically(directory + "/walls/" + walls.names()[static_cast<std::size_t>(rows[first][0])] + number,
                            text);
      first = row;
    }
  });
}

}  // namespace scree

#include "scree/stepping/presets.hpp"

#include <algorithm>
#include <cmath>

#include "scree/balances/layout.hpp"
#include "scree/grid/axis_name.hpp"

namespace scree {

namespace {

std::string component_list(int first, int count) {
  std::string list;
  for (int c = first; c < first + count; ++c) list += (c > first ? "," : "") + std::to_string(c);
  return list;
}

/// Newton for every preset; the line search is ours unless one is named.
const PetscOptionList newton{{"snes_type", "newtonls"}};

/// Factorisation by MUMPS; GMRES around it lets a factorisation serve several Newton steps. Small cases, reference.
/// The ordering is MUMPS's choice, PORD: Debian's build falls back to it when asked for METIS (ICNTL(7) = 5). AMF
/// (ICNTL(7) = 2) is a little cheaper in two dimensions and dearer in three.
const PetscOptionList direct{{"ksp_type", "gmres"},       {"ksp_pc_side", "right"},
                             {"ksp_rtol", "1e-6"},        {"ksp_max_it", "30"},
                             {"pc_type", "lu"},           {"pc_factor_mat_solver_type", "mumps"},
                             {"mat_mumps_icntl_14", "60"}};

/// Preconditioners of a block of unknowns: one ILU(1) a rank ...
const PetscOptionList ilu_block{{"pc_type", "bjacobi"},
                                {"sub_ksp_type", "preonly"},
                                {"sub_pc_type", "ilu"},
                                {"sub_pc_factor_levels", "1"},
                                {"sub_pc_factor_shift_type", "nonzero"}};

/// ... or one multigrid cycle: plain aggregation of nodes (all unknowns of a node together), ILU(1) on each rank as
/// smoother. ILU alone is slow in the smooth pressure modes that span the bed; the coarse levels carry these.
/// The aggregates depend on the pattern of the matrix alone: kept, they give the same iterations to the last, and a
/// set-up costs a third. PETSc does not hand the lag of the preconditioner down to the smoothers: the ILU of the finest
/// level is always that of the latest Jacobian. Held, it takes twice the iterations. A level of up to 5000 unknowns is
/// factored, on one rank: smaller ones cost more messages than work.
const PetscOptionList multigrid_block{{"pc_type", "gamg"},
                                      {"pc_gamg_type", "agg"},
                                      {"pc_gamg_agg_nsmooths", "0"},
                                      {"pc_gamg_coarse_eq_limit", "5000"},
                                      {"pc_gamg_reuse_interpolation", "true"},
                                      {"mg_levels_ksp_type", "richardson"},
                                      {"mg_levels_ksp_max_it", "1"},
                                      {"mg_levels_pc_type", "bjacobi"},
                                      {"mg_levels_sub_pc_type", "ilu"},
                                      {"mg_levels_sub_pc_factor_levels", "1"},
                                      {"mg_levels_sub_pc_factor_shift_type", "nonzero"}};

/// One ILU(`fill`) a rank. For the steps that accuracy mostly allows with gas ILU(0) suffices: it takes about as many
/// iterations as ILU(1), and each is cheaper. SolverChoice finds where it does not.
PetscOptionList ilu_block_with(int fill) {
  PetscOptionList list{{"sub_pc_factor_levels", std::to_string(fill)}};
  for (const auto& option : ilu_block)
    if (option.first != "sub_pc_factor_levels") list.push_back(option);
  return list;
}

/// GMRES for fixed preconditioners. They stand on the right: left-preconditioned norms converge falsely.
PetscOptionList gmres(const std::string& tolerance, const std::string& most_iterations) {
  return {{"ksp_type", "gmres"},
          {"ksp_pc_side", "right"},
          {"ksp_gmres_restart", "100"},
          {"ksp_max_it", most_iterations},
          {"ksp_rtol", tolerance}};
}

/// For preconditioners that hold a Krylov method themselves.
const PetscOptionList flexible_gmres{
    {"ksp_type", "fgmres"}, {"ksp_gmres_restart", "60"}, {"ksp_max_it", "100"}, {"ksp_rtol", "1e-2"}};

/// The options of `list` for the solver of a block.
PetscOptionList with_prefix(const std::string& prefix, const PetscOptionList& list) {
  PetscOptionList result;
  for (const auto& [name, value] : list) result.emplace_back(prefix + name, value);
  return result;
}

/// Pressure waves couple nu to v: their Schur complement on nu is elliptic and goes to BoomerAMG, v with T and chi to
/// aggregation multigrid with ILU(1), which on long steps takes a quarter of the iterations of ILU(0).
PetscOptionList solids_fieldsplit(int unknowns) {
  PetscOptionList list{{"ksp_type", "fgmres"},
                       {"ksp_gmres_restart", "60"},
                       {"ksp_max_it", "100"},
                       {"ksp_rtol", "3e-2"},
                       {"pc_type", "fieldsplit"},
                       {"pc_fieldsplit_type", "schur"},
                       {"pc_fieldsplit_dm_splits", "false"},  // by component, or GAMG gets a grid without vectors
                       {"pc_fieldsplit_schur_fact_type", "full"},
                       {"pc_fieldsplit_schur_precondition", "selfp"},
                       {"pc_fieldsplit_0_fields", component_list(1, unknowns - 1)},
                       {"pc_fieldsplit_1_fields", component_list(0, 1)},
                       {"fieldsplit_0_ksp_type", "preonly"},
                       {"fieldsplit_1_ksp_type", "gmres"},
                       {"fieldsplit_1_ksp_max_it", "5"},
                       {"fieldsplit_1_pc_type", "hypre"},
                       {"fieldsplit_1_pc_hypre_type", "boomeramg"}};
  for (const auto& option : with_prefix("fieldsplit_0_", multigrid_block)) list.push_back(option);
  return list;
}

/// The Schur complement on p_g, to which one V-cycle of BoomerAMG is applied. The diagonal of the rows of u
/// holds the drag, so that stiff drag costs no iterations: what is left is the mobility of the gas. `rest` is the
/// preconditioner of all other unknowns.
PetscOptionList gas_fieldsplit(int unknowns, int gas_pressure, const PetscOptionList& rest) {
  const std::string before = component_list(0, gas_pressure),
                    after = component_list(gas_pressure + 1, unknowns - gas_pressure - 1);
  PetscOptionList list{{"pc_type", "fieldsplit"},
                       {"pc_fieldsplit_type", "schur"},
                       {"pc_fieldsplit_dm_splits", "false"},
                       {"pc_fieldsplit_schur_fact_type", "upper"},
                       {"pc_fieldsplit_schur_precondition", "selfp"},
                       {"pc_fieldsplit_0_fields", before + (after.empty() ? "" : ",") + after},
                       {"pc_fieldsplit_1_fields", component_list(gas_pressure, 1)},
                       {"fieldsplit_0_ksp_type", "preonly"},
                       {"fieldsplit_1_ksp_type", "preonly"},
                       {"fieldsplit_1_pc_type", "hypre"},
                       {"fieldsplit_1_pc_hypre_type", "boomeramg"}};
  for (const auto& option : with_prefix("fieldsplit_0_", rest)) list.push_back(option);
  return list;
}

/// A factor by MUMPS, made on one of the ranks: those that share one add up in the order in which messages come, and a
/// restart would not end bit for bit as the uninterrupted run. In two dimensions they save little: other ranks wait.
PetscOptionList factor(int ranks) {
  PetscOptionList own{{"pc_type", "lu"}, {"pc_factor_mat_solver_type", "mumps"}, {"mat_mumps_icntl_14", "60"}};
  if (ranks == 1) return own;
  PetscOptionList list{{"pc_type", "telescope"},
                       {"pc_telescope_reduction_factor", std::to_string(ranks)},
                       {"pc_telescope_ignore_dm", "true"}};
  for (const auto& option : with_prefix("telescope_", own)) list.push_back(option);
  return list;
}

/// One cycle over coarser grids, smoothed by two steps of GMRES with an incomplete factor on each rank: ILU(0) in
/// space, ILU(1) in the plane, where cells are flatter. Fixed sweeps take three to six times the iterations.
/// In the plane nodes go by columns along gravity, as in ILU of all unknowns: by rows graded cells find no end, and by
/// reverse Cuthill-McKee those of a quarter take four times the iterations.
PetscOptionList geometric_multigrid(const std::string& face_axes, int dim, int ranks, const PetscOptionList& ordering) {
  PetscOptionList list{{"pc_type", "staggered"},
                       {"pc_staggered_axes", face_axes},
                       {"staggered_mg_levels_ksp_type", "gmres"},
                       {"staggered_mg_levels_ksp_max_it", "2"},
                       {"staggered_mg_levels_pc_type", "bjacobi"},
                       {"staggered_mg_levels_sub_pc_type", "ilu"},
                       {"staggered_mg_levels_sub_pc_factor_levels", dim > 2 ? "0" : "1"},
                       {"staggered_mg_levels_sub_pc_factor_shift_type", "nonzero"}};
  if (dim < 3)
    for (const auto& option : with_prefix("staggered_mg_levels_sub_", ordering)) list.push_back(option);
  for (const auto& option : with_prefix("staggered_mg_coarse_", factor(ranks))) list.push_back(option);
  return list;
}

/// A factor is made on one rank, a cycle of multigrid by all: the factor of a plane core takes less time up to about
/// this product of cells and ranks.
constexpr double factored_cells = 25000;

/// T, chi and u eliminated in their nodes. The rest, what these exchange with their neighbours, is solved for by GMRES
/// with ILU(1): with one application of that the whole takes twice the iterations, and on blocks of eight ranks five
/// times. The core has a factor, and where factors are dear, multigrid. Where a scene has none of the three the core is
/// all there is. u acts in its node through the drag of moving particles: where none move, it stays in the core.
PetscOptionList condensed(const std::vector<Field>& node, int dim, const PresetScene& scene,
                          const PetscOptionList& ordering) {
  std::string eliminated, face_axes;
  const auto append = [](std::string& list, int number) { list += (list.empty() ? "" : ",") + std::to_string(number); };
  for (const Field& field : node)
    if (field.unknown->acts_in_its_node && (scene.solids_moving || field.face_axis < 0))
      append(eliminated, field.component);
    else
      append(face_axes, field.face_axis);
  const bool factored = dim < 3 && scene.cells * scene.ranks < factored_cells;
  PetscOptionList core = factored ? factor(scene.ranks) : geometric_multigrid(face_axes, dim, scene.ranks, ordering);
  if (eliminated.empty()) return core;
  PetscOptionList list{{"pc_type", "condensed"}, {"pc_condensed_eliminated", eliminated}};
  for (const auto& option : with_prefix("condensed_core_", core)) list.push_back(option);
  for (const auto& option : with_prefix("condensed_rest_", gmres("1e-2", "20"))) list.push_back(option);
  for (const auto& option : with_prefix("condensed_rest_", ilu_block)) list.push_back(option);
  for (const auto& option : with_prefix("condensed_rest_sub_", ordering)) list.push_back(option);
  return list;
}

/// The order in which an incomplete factor takes the nodes: columns along gravity, or along the last axis, see
/// orderings.hpp. In that of the rows, on graded cells, it takes three to six times the iterations.
PetscOptionList column_ordering(const std::array<double, max_dim>& gravity, int dim) {
  int axis = dim - 1;
  for (int a = 0; a < dim; ++a)
    if (std::abs(gravity[a]) > std::abs(gravity[axis])) axis = a;
  return {{"pc_factor_mat_ordering_type", "columns_" + axis_name(axis)}};
}

}  // namespace

PetscOptionList preset_options(SolverPreset preset, const std::vector<Field>& node, const PresetScene& scene) {
  const auto unknowns = static_cast<int>(node.size());
  int gas_pressure = -1, dim = 0;
  for (const Field& field : node) {
    if (field.is<GasContinuity>()) gas_pressure = field.component;
    dim = std::max(dim, field.face_axis + 1);
  }
  PetscOptionList list = newton;
  const bool gas = gas_pressure >= 0;
  const PetscOptionList columns = column_ordering(scene.gravity, std::max(dim, 1));
  const auto append = [&](const PetscOptionList& more) {  // what is there already wins
    for (const auto& option : more)
      if (std::none_of(list.begin(), list.end(), [&](const auto& o) { return o.first == option.first; }))
        list.push_back(option);
  };
  switch (preset) {
    case SolverPreset::direct:
      append(direct);
      break;
    case SolverPreset::ilu:
      append(gmres("1e-2", gas ? "300" : "150"));
      append(with_prefix("sub_", columns));
      append(ilu_block_with(gas ? 2 : dim > 2 ? 0 : 1));  // in space a set-up of ILU(1) costs ten of ILU(0)
      break;
    case SolverPreset::multigrid:
      append(gas ? gmres("1e-2", "200") : gmres("3e-2", "100"));
      if (!gas) append(with_prefix("mg_levels_sub_", columns));
      append(gas ? gas_fieldsplit(unknowns, gas_pressure, multigrid_block) : multigrid_block);
      break;
    case SolverPreset::fieldsplit:
      if (gas) append(gmres("1e-2", "200"));
      append(gas ? gas_fieldsplit(unknowns, gas_pressure, ilu_block_with(scene.fill)) : solids_fieldsplit(unknowns));
      break;
    case SolverPreset::condensed:
      append(flexible_gmres);
      append(condensed(node, dim, scene, columns));
      break;
  }
  return list;
}

}  // namespace scree

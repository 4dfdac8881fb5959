#include "scree/stepping/presets.hpp"

#include <algorithm>
#include <stdexcept>

#include "scree/stepping/orderings.hpp"

namespace scree {

namespace {

std::string component_list(int first, int count) {
  std::string list;
  for (int c = first; c < first + count; ++c) list += (c > first ? "," : "") + std::to_string(c);
  return list;
}

/// Newton for every preset; the line search is ours unless one is named.
const PetscOptionList newton{{"snes_type", "newtonls"}, {"snes_max_it", "15"}};

/// Factorisation by MUMPS; GMRES around it lets a factorisation serve several Newton steps. Small cases, reference.
/// The ordering is MUMPS's choice, PORD: Debian's build falls back to it when asked for METIS (ICNTL(7) = 5). On the
/// plateau of the 1 mm bin, 40 x 526 cells, a factorisation on a known pattern takes .72 s and 57 M entries with PORD,
/// .62 s and 51 M with AMF (ICNTL(7) = 2, which takes 11 % longer in three dimensions), .89 s and 62 M with METIS's
/// nested dissection of the nodes handed to MUMPS; UMFPACK with METIS .77 s, SuperLU_DIST with METIS 1.6 s.
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
/// set-up on the 1 mm bin, 40 x 526 cells, takes .085 s instead of .28 s (a solution: .16 s). PETSc does not hand the
/// lag of the preconditioner down to the smoothers: the ILU of the finest level is always that of the latest Jacobian.
/// Held, it takes twice the iterations. A level of up to 5000 unknowns is factored, on one rank: smaller ones cost
/// more messages than work (the plateau on 2 ranks takes .70 of the iterations and .74 of the time).
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

/// One ILU(`fill`) a rank. For the steps that accuracy mostly allows with gas ILU(0) suffices: the bubble to .5 s takes
/// 2429 Krylov iterations in place of 2405 with ILU(1), and .87 of the time. PresetTrial says where it does not.
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

/// For ILU alone, whose many iterations would be a fifth orthogonalisation and 2 kB a cell with GMRES. Its factor is
/// made at every Newton iteration: that costs eight iterations and saves more (1 mm bin on 20 x 263 cells to 1.1 s:
/// 4239 instead of 7391 with GMRES).
const PetscOptionList bicgstab{{"ksp_type", "bcgs"},
                               {"ksp_pc_side", "right"},
                               {"ksp_max_it", "150"},
                               {"ksp_rtol", "3e-2"},
                               {"snes_lag_preconditioner", "1"}};

/// The options of `list` for the solver of a block.
PetscOptionList with_prefix(const std::string& prefix, const PetscOptionList& list) {
  PetscOptionList result;
  for (const auto& [name, value] : list) result.emplace_back(prefix + name, value);
  return result;
}

/// Pressure waves couple nu to v: their Schur complement on nu is elliptic and goes to BoomerAMG, v with T and chi to
/// aggregation multigrid with ILU(1): 25 iterations on the 1 mm bin, 40 x 526 cells, dt = 1e-2 s, against 93 with
/// ILU(0).
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

/// One ILU(2) a rank for all unknowns, p_g among them.
const PetscOptionList gas_ilu{{"sub_pc_factor_levels", "2"}, {"sub_pc_factor_mat_ordering_type", "last_node_first"}};

}  // namespace

PetscOptionList preset_options(const std::string& preset, int unknowns, int gas_pressure, int fill) {
  PetscOptionList list = newton;
  const bool gas = gas_pressure >= 0;
  const auto append = [&](const PetscOptionList& more) {  // what is there already wins
    for (const auto& option : more)
      if (std::none_of(list.begin(), list.end(), [&](const auto& o) { return o.first == option.first; }))
        list.push_back(option);
  };
  if (preset == "direct") {
    append(direct);
  } else if (preset == "ilu") {
    append(gas ? gmres("1e-2", "300") : bicgstab);
    if (gas) append(gas_ilu);
    append(ilu_block);
  } else if (preset == "multigrid") {
    append(gas ? gmres("1e-2", "200") : gmres("3e-2", "100"));
    append(gas ? gas_fieldsplit(unknowns, gas_pressure, multigrid_block) : multigrid_block);
  } else if (preset == "fieldsplit") {
    if (gas) append(gmres("1e-2", "200"));
    append(gas ? gas_fieldsplit(unknowns, gas_pressure, ilu_block_with(fill)) : solids_fieldsplit(unknowns));
  } else {
    throw std::invalid_argument("solver preset '" + preset + "'");
  }
  return list;
}

PetscErrorCode apply_preset(const std::string& preset, int unknowns, int gas_pressure, std::vector<std::string>* added,
                            int fill) {
  PetscFunctionBeginUser;
  PetscCall(register_orderings());
  for (const auto& [name, value] : preset_options(preset, unknowns, gas_pressure, fill)) {
    const std::string option = "-" + name;
    PetscBool set;
    PetscCall(PetscOptionsHasName(nullptr, nullptr, option.c_str(), &set));
    if (set) continue;
    PetscCall(PetscOptionsSetValue(nullptr, option.c_str(), value.c_str()));
    if (added) added->push_back(name);
  }
  PetscFunctionReturn(0);
}

PetscErrorCode remove_options(const std::vector<std::string>& names) {
  PetscFunctionBeginUser;
  for (const std::string& name : names) PetscCall(PetscOptionsClearValue(nullptr, ("-" + name).c_str()));
  PetscFunctionReturn(0);
}

}  // namespace scree

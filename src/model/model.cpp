#include "scree/model/model.hpp"

#include "scree/balances/present.hpp"

namespace scree {

/// Explicitly instantiated, one file a dimension and gas model.
template <int dim, GasModel gas, class... Scalars>
std::unique_ptr<Model> choose_model(const ModelSetup& setup);

/// Two dimensions without gas; with relaxed friction.
std::unique_ptr<Model> with_fluidity(const ModelSetup& setup);

namespace {

template <int dim>
std::unique_ptr<Model> with_gas(const ModelSetup& setup) {
  if constexpr (dim == 2)
    if (has_fluidity(setup.solids.friction) && setup.solids.gas.model == GasModel::none) return with_fluidity(setup);
  switch (setup.solids.gas.model) {
    case GasModel::none:
      return choose_model<dim, GasModel::none>(setup);
    case GasModel::darcy:
      return choose_model<dim, GasModel::darcy>(setup);
    default:
      return choose_model<dim, GasModel::incompressible>(setup);
  }
}

}  // namespace

std::vector<Field> ModelFactory::fields(int dim, const ModelParameters& model, const SolidsParameters& solids,
                                        const Scales& scales) const {
  std::vector<const Unknown*> all = present_unknowns(model, solids);
  all.insert(all.end(), further.begin(), further.end());
  return fields_of(all, dim, scales);
}

std::pair<int, int> ModelFactory::extent(int dim, const ModelParameters& model, const SolidsParameters& solids) const {
  const int unknowns = static_cast<int>(fields(dim, model, solids, Scales()).size());
  return {unknowns, model.advection == AdvectionScheme::upwind ? 2 : 3};
}

std::unique_ptr<Model> make_model(const ModelSetup& setup) {
  switch (setup.lattice.dim) {
    case 1:
      return with_gas<1>(setup);
    case 2:
      return with_gas<2>(setup);
    default:
      return with_gas<3>(setup);
  }
}

}  // namespace scree

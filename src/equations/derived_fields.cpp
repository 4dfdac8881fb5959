#include "scree/equations/derived_fields.hpp"

#include "scree/equations/assembly.hpp"
#include "scree/equations/cell_strain.hpp"
#include "scree/equations/layout.hpp"

namespace scree {

namespace {

/// The closures that the fields are, in their order.
std::vector<CellClosure::Entry> entries(const ModelParameters& model, const SolidsParameters& solids) {
  std::vector<CellClosure::Entry> list;
  if (model.temperature == TemperatureModel::algebraic) list.push_back(CellClosure::temperature);
  if (solids.friction.model != FrictionModel::none) list.push_back(CellClosure::frictional_pressure);
  return list;
}

/// Gives a cell the inputs of its closures, as a kernel would.
template <class L>
struct CellInputs {
  static constexpr StencilBuilder stencil = cell_stencil<L>();
  static Reference resolve(const Scene&, const Index&, const Input& input) { return {input.offset, 1}; }
};

template <class L>
std::vector<std::vector<double>> values(const ModelSetup& setup, const double* state) {
  const Lattice& grid = setup.lattice;
  Assembly assembly{{setup.lattice, setup.barriers, setup.model, setup.solids}, L::count, {}, {}, {}, {}};
  for (const Field& field : fields_of<L>(setup.scales))
    assembly.scale[static_cast<std::size_t>(field.component)] = field.scale;
  const auto wanted = entries(setup.model, setup.solids);
  std::vector<std::vector<double>> result(wanted.size(),
                                          std::vector<double>(static_cast<std::size_t>(grid.owned_size()), 0.0));
  for_each_node(grid.owned_first, grid.owned_count, [&](const Index& I) {
    if (!grid.inside(I)) return;
    Local<CellInputs<L>, double> q;
    assembly.gather(state, I, q);
    const auto [T, p_f] = cell_closures<L, CellClosure::temperature, CellClosure::frictional_pressure>(
        assembly.scene, I, q, cell_strain<L>(assembly.scene, I, q));
    for (std::size_t k = 0; k < wanted.size(); ++k)
      result[k][static_cast<std::size_t>(grid.owned(I))] = wanted[k] == CellClosure::temperature ? T : p_f;
  });
  return result;
}

/// Calls work(Layout) for the layout that make_model takes.
template <int dim, class Work>
auto with_layout(const ModelParameters& model, const SolidsParameters& solids, Work&& work) {
  const bool T = model.temperature == TemperatureModel::transport;
  const bool chi = solids.friction.model == FrictionModel::relaxed;
  const auto with_gas = [&](auto gas) {
    constexpr GasModel g = decltype(gas)::value;
    if (T) return chi ? work(Layout<dim, true, true, g>()) : work(Layout<dim, true, false, g>());
    return chi ? work(Layout<dim, false, true, g>()) : work(Layout<dim, false, false, g>());
  };
  switch (solids.gas.model) {
    case GasModel::none:
      return with_gas(std::integral_constant<GasModel, GasModel::none>());
    case GasModel::darcy:
      return with_gas(std::integral_constant<GasModel, GasModel::darcy>());
    default:
      return with_gas(std::integral_constant<GasModel, GasModel::incompressible>());
  }
}

template <class Work>
auto with_layout(int dim, const ModelParameters& model, const SolidsParameters& solids, Work&& work) {
  switch (dim) {
    case 1:
      return with_layout<1>(model, solids, work);
    case 2:
      return with_layout<2>(model, solids, work);
    default:
      return with_layout<3>(model, solids, work);
  }
}

}  // namespace

std::vector<Field> unknown_fields(int dim, const ModelParameters& model, const SolidsParameters& solids,
                                  const Scales& scales) {
  return with_layout(dim, model, solids, [&](auto layout) { return fields_of<decltype(layout)>(scales); });
}

std::vector<Field> derived_fields(const ModelParameters& model, const SolidsParameters& solids) {
  std::vector<Field> fields;
  for (const CellClosure::Entry entry : entries(model, solids)) {
    const int place = static_cast<int>(fields.size());
    if (entry == CellClosure::temperature)
      fields.push_back(
          {"granular_temperature", "T", "m2/s2", "granular temperature, (9) without storage and fluxes", place, -1, 1});
    else
      fields.push_back({"frictional_pressure", "p_f", "Pa", "frictional pressure chi p_c, (10)", place, -1, 1});
  }
  return fields;
}

std::vector<std::vector<double>> derived_values(const ModelSetup& setup, const double* state) {
  return with_layout(setup.lattice.dim, setup.model, setup.solids,
                     [&](auto layout) { return values<decltype(layout)>(setup, state); });
}

}  // namespace scree

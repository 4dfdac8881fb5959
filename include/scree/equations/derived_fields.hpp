/// Fields of a scene for output, known without its grid: the unknowns, and what follows from them cell by cell.
#pragma once

#include <vector>

#include "scree/equations/model.hpp"

namespace scree {

/// The unknowns that a model of `dim` dimensions has with these parameters, as Model::fields gives them.
std::vector<Field> unknown_fields(int dim, const ModelParameters& model, const SolidsParameters& solids,
                                  const Scales& scales);

/// Cell-centred fields that are no unknowns: T where it is algebraic, p_f where there is friction. Their component is
/// their place in this list, their scale 1.
std::vector<Field> derived_fields(const ModelParameters& model, const SolidsParameters& solids);

/// Values of derived_fields at the owned nodes in SI, one array a field in the order of Lattice::owned, 0 outside of
/// the box. `state` is stored over ghosted nodes, as for Model::residual.
std::vector<std::vector<double>> derived_values(const ModelSetup& setup, const double* state);

}  // namespace scree

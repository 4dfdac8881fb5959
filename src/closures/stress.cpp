/// The closure of a face, compiled once for the number types that kernels use.
#include "scree/closures/stress.hpp"

namespace scree {

template <class Number>
Number face_conductivity(const Number& nu, const Number& T, const Number& slip_squared, const SolidsParameters& p) {
  const Number sqrt_T = sqrt_temperature(T, p.temperature_floor);
  if (p.gas.model == GasModel::none) return conductivity(nu, sqrt_T, p.kinetic);
  return conductivity(nu, sqrt_T, drag_over_nu(nu, slip_squared, p.kinetic.d, p.gas), p.kinetic);
}

#define SCREE_INSTANTIATE(Number) \
  template Number face_conductivity(const Number&, const Number&, const Number&, const SolidsParameters&);
SCREE_INSTANTIATE(double)
SCREE_INSTANTIATE(Dual<2>)
SCREE_INSTANTIATE(Dual<3>)
#undef SCREE_INSTANTIATE

}  // namespace scree

#include "scree/boundary/inlet_variation.hpp"

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

/// Integral of a shape from the middle of the patch to s.
double integral(InletShape shape, double exponent, double s) {
  switch (shape) {
    case InletShape::parabolic:
      return 1.5 * (s - s * s * s / 3);
    case InletShape::power:
      return std::copysign(1 - std::pow(1 - std::abs(s), 1 + 1 / exponent), s);
    case InletShape::uniform:
      break;
  }
  return s;
}

}  // namespace

double Ramp::value(double x) const {
  if (at.empty()) return 1;
  const auto after = std::upper_bound(at.begin(), at.end(), x) - at.begin();
  if (after == 0) return factor.front();
  if (after == static_cast<std::ptrdiff_t>(at.size())) return factor.back();
  const double share = (x - at[after - 1]) / (at[after] - at[after - 1]);
  return factor[after - 1] + share * (factor[after] - factor[after - 1]);
}

double InletVariation::value(const FaceExtent& face, double time) const {
  double factor = profile.value(face.centre(axis)) * in_time(time);
  for (int a = 0; a < max_dim && shape != InletShape::uniform; ++a) {
    if (!(upper[a] > lower[a])) continue;
    const auto across = [&](double x) {
      return std::clamp((2 * x - lower[a] - upper[a]) / (upper[a] - lower[a]), -1.0, 1.0);
    };
    const double from = across(face.lower[a]), to = across(face.upper[a]);
    if (to > from) factor *= (integral(shape, exponent, to) - integral(shape, exponent, from)) / (to - from);
  }
  return factor;
}

double InletVariation::in_time(double time) const {
  const double x = rise_time > 0 ? std::clamp((time - begin) / rise_time, 0.0, 1.0) : 1;
  return history.value(time) * x * x * (3 - 2 * x);
}

}  // namespace scree

/// Constants of mathematics.
#pragma once

namespace scree {

inline constexpr double pi = 3.14159265358979323846;
inline constexpr double sqrt_pi = 1.77245385090551602730;

}  // namespace scree

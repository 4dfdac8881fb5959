/// A kind of boundary from outside: a screen that keeps particles back by friction and lets gas through.
#pragma once

#include "scree/boundary/kind.hpp"

inline constexpr scree::BoundaryKind screen{"screen",
                                            "keeps particles back, lets gas through",
                                            scree::SolidsNormal::wall,
                                            scree::SolidsTangential::johnson_jackson,
                                            scree::Scalars::closed,
                                            scree::GasNormal::open,
                                            scree::GasTangential::free,
                                            scree::GasPressure::prescribed};

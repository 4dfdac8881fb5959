/// What a time scheme asks Newton's method to solve.
#pragma once

#include <petscvec.h>

namespace scree {

/// F(time, U, rate) = 0 for U, where d(rate)/dU = shift.
struct Stage {
  double time = 0;     ///< of the unknown state [s]
  double shift = 0;    ///< [1/s]
  Vec rate = nullptr;  ///< dU/dt that belongs to the last residual; not owned [1/s]
};

}  // namespace scree

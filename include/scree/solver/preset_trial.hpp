/// Which of two presets a run with gas goes on with: numbers in, a decision out.
#pragma once

#include <algorithm>

namespace scree {

/// With gas the cheaper preset depends on more than the size. The bubbling bed takes 2.5 iterations a linear system
/// with fieldsplit, in two thirds of the time that multigrid takes; the 1 mm bin in air, of as many cells, takes 84
/// and 3.4 times the time, multigrid 12. So where fieldsplit takes many, multigrid is tried. Where that does not pay,
/// as in beds packed to nu_max, fieldsplit comes back, each time for twice as long.
class PresetTrial {
 public:
  /// Adds the iterations of a step. True if the other preset shall take its turn, as multigrid() then says.
  bool turns(int newton, int krylov) {
    newton_ += newton;
    krylov_ += krylov;
    if (newton_ < (multigrid_ || returns_ == 0 ? enough : enough << std::min(returns_ + 3, 12))) return false;
    iterations_ = static_cast<double>(krylov_) / newton_;
    newton_ = krylov_ = 0;
    const bool turn = multigrid_ ? iterations_ > paying * with_fieldsplit_ : iterations_ > many;
    if (!turn) return false;
    if (multigrid_)
      ++returns_;
    else
      with_fieldsplit_ = iterations_;
    multigrid_ = !multigrid_;
    return true;
  }

  bool multigrid() const { return multigrid_; }
  /// Krylov iterations a linear system on which the last decision rests.
  double iterations() const { return iterations_; }

 private:
  static constexpr int enough = 10;  ///< Newton iterations for a decision
  static constexpr int many = 50;    ///< Krylov iterations a linear system
  /// Of fieldsplit's iterations. One of multigrid costs 2.5 times as much, but the steps that it allows are longer.
  static constexpr double paying = 0.6;

  bool multigrid_ = false;
  int newton_ = 0, krylov_ = 0;
  int returns_ = 0;
  double with_fieldsplit_ = 0, iterations_ = 0;
};

}  // namespace scree

/// Which of two presets a run goes on with: numbers in, a decision out.
#pragma once

#include <algorithm>

namespace scree {

/// The cheaper preset depends on more than the size. Without gas `ilu` is cheaper than its iterations a linear system
/// let expect, since Newton's method and steps do better with it. Plateau of the 1 mm bin on 40 x 526 cells: 20
/// iterations in steps of .02 s, multigrid 16 to 40 in steps of .013 s and twice the time; on 80 x 1052 cells 70 and
/// 28, and five sixths of multigrid's time. With gas the bubbling bed takes 2.5 with `fieldsplit`, in two thirds of the
/// time that multigrid takes; the 1 mm bin in air, of as many cells, 84 and 3.4 times the time, multigrid 12. So where
/// the first preset takes many, multigrid is tried. Where that does not pay, as in beds packed to nu_max, the first
/// comes back, each time for twice as long.
class PresetTrial {
 public:
  struct Rule {
    double many;    ///< Krylov iterations a linear system with the first preset, above which multigrid is tried
    double paying;  ///< of them, up to which multigrid is kept
  };
  /// ilu: one iteration of multigrid costs 1.7 times as much.
  static constexpr Rule without_gas{80, 0.45};
  /// fieldsplit: one iteration of multigrid costs 2.5 times as much, but the steps that it allows are longer.
  static constexpr Rule with_gas{50, 0.6};

  /// What a checkpoint has to hold.
  struct State {
    bool multigrid = false;
    int newton = 0, krylov = 0;  ///< since the last decision
    int returns = 0;
    double with_first = 0;  ///< iterations a linear system when the first preset was left
  };

  explicit PresetTrial(Rule rule) : rule_(rule) {}

  /// Adds the iterations of a step. True if the other preset shall take its turn, as multigrid() then says.
  bool turns(int newton, int krylov) {
    state_.newton += newton;
    state_.krylov += krylov;
    if (state_.newton < enough()) return false;
    iterations_ = static_cast<double>(state_.krylov) / state_.newton;
    state_.newton = state_.krylov = 0;
    const bool turn = state_.multigrid ? iterations_ > rule_.paying * state_.with_first : iterations_ > rule_.many;
    if (!turn) return false;
    if (state_.multigrid)
      ++state_.returns;
    else
      state_.with_first = iterations_;
    state_.multigrid = !state_.multigrid;
    return true;
  }

  bool multigrid() const { return state_.multigrid; }
  /// Krylov iterations a linear system on which the last decision rests.
  double iterations() const { return iterations_; }
  State& state() { return state_; }

 private:
  /// Newton iterations for a decision.
  int enough() const {
    const bool again = !state_.multigrid && state_.returns > 0;
    return again ? 10 << std::min(state_.returns + 3, 12) : 10;
  }

  Rule rule_;
  State state_;
  double iterations_ = 0;
};

}  // namespace scree

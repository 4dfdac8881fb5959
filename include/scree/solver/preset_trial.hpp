/// Which of two presets a run goes on with: numbers in, a decision out.
#pragma once

#include <algorithm>

namespace scree {

/// The cheaper preset depends on more than the size. Without gas `ilu` is the cheaper one while it takes few iterations
/// a linear system: the first .1 s of the 1 mm bin, 40 x 526 cells on one rank, takes 5.2 of them, multigrid 5.1
/// and 1.4 times the time. In the plateau, from 2 to 2.2 s, it takes 22, multigrid 18 and 1.6 times the time; on two
/// ranks, where aggregates are others, 23 and 14, and multigrid .94 of the time. With gas the bubbling bed takes 2.5
/// with `fieldsplit`, in two thirds of the time that multigrid takes; the 1 mm bin in air, of as many cells, 84 and 3.4
/// times the time, multigrid 12. So where the first preset takes many, multigrid is tried. Where that does not pay, as
/// in beds packed to nu_max, the first comes back, each time for twice as long.
class PresetTrial {
 public:
  struct Rule {
    double many;    ///< Krylov iterations a linear system with the first preset, above which multigrid is tried
    double paying;  ///< of them, up to which multigrid is kept
    int patience;   ///< with which the first preset is given time after its return, growing
  };
  /// ilu: one iteration of multigrid costs twice as much, but its set-up serves a whole step.
  /// As steps grow with the plateau, what it took when it was left says less and less: it is soon asked again.
  static constexpr Rule without_gas{15, 0.75, 1};
  /// fieldsplit: one iteration of multigrid costs 2.5 times as much, but the steps that it allows are longer.
  static constexpr Rule with_gas{50, 0.6, 8};

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
    return again ? 10 * rule_.patience << std::min(state_.returns, 9) : 10;
  }

  Rule rule_;
  State state_;
  double iterations_ = 0;
};

}  // namespace scree

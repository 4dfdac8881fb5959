/// Which of two presets a run goes on with: numbers in, a decision out.
#pragma once

#include <algorithm>

namespace scree {

/// The cheaper preset depends on more than the size. Without gas `ilu` is the cheaper one while it takes few iterations
/// a linear system, as at the start of a discharge; in its plateau multigrid is, the more so the more ranks there are.
/// With gas `fieldsplit` with ILU(0) in it is cheaper by a third in a bubbling bed, and several times dearer in a bin
/// in air, where it takes many iterations. So where the first preset takes many, multigrid is tried. Where that does
/// not pay, as in beds packed to nu_max, the first comes back, until it takes so many that multigrid, by what it took,
/// would pay, or for a while, each time twice as long.
///
/// Before multigrid comes fill: ILU(1) in `fieldsplit` takes two thirds of the iterations of ILU(0), each a little
/// dearer, and a dearer set-up: it pays where iterations are many. tests/benchmark measures all these.
///
/// The many iterations of a step whose first attempt failed say nothing of the preset, unless steps fail often.
class PresetTrial {
 public:
  struct Rule {
    double many;      ///< Krylov iterations a linear system with the first preset, above which multigrid is tried
    double paying;    ///< of them, up to which multigrid is kept
    double filling;   ///< iterations with the first preset, above which its ILU is given one level of fill more
    double emptying;  ///< ... and below which that is taken from it again
    int patience;     ///< windows after which multigrid is tried again though it did not pay, growing with each return
  };
  static constexpr double never = 1e300;  ///< more iterations than any system takes
  /// ilu: one iteration of multigrid costs twice as much, but its set-up serves a whole step.
  /// As steps grow with the plateau, what multigrid took says less and less: it is soon asked again.
  static constexpr Rule without_gas{15, 0.75, never, 0, 2};
  /// fieldsplit: one iteration of multigrid costs 2.4 times as much as with ILU(0), twice as much as with ILU(1), its
  /// set-up included. A bed that nothing but collisions holds up packs to nu_max: there multigrid fails twenty times as
  /// many steps as ILU(0), so it has to save more iterations and is seldom asked again; ILU(1) fails seven times as
  /// many.
  static constexpr Rule with_gas{45, 0.5, 12, 4, 16};
  static constexpr Rule with_gas_without_friction{70, 0.25, never, 0, 16};
  static constexpr int window = 10;  ///< Newton iterations for a decision
  static constexpr int seldom = 7;   ///< steps between failures, up to which these count

  /// What a checkpoint has to hold.
  struct State {
    bool multigrid = false;
    int fill = 0;                  ///< levels of fill that the first preset has more than by itself
    int newton = 0, krylov = 0;    ///< of the window so far
    int returns = 0, windows = 0;  ///< to the first preset, and with it since the last of them
    int since_failure = seldom;    ///< steps since one of which an attempt failed, `seldom` at most
    double with_first = 0;         ///< iterations a linear system when the first preset was left
    double with_multigrid = 0;     ///< ... and when multigrid was

    /// Calls visit(name, member) for each; the names are those in checkpoints.
    template <class Visitor>
    void each_member(Visitor&& visit) {
      visit("trial_multigrid", multigrid);
      visit("trial_fill", fill);
      visit("trial_newton", newton);
      visit("trial_krylov", krylov);
      visit("trial_returns", returns);
      visit("trial_windows", windows);
      visit("trial_since_failure", since_failure);
      visit("trial_with_first", with_first);
      visit("trial_with_multigrid", with_multigrid);
    }
  };

  explicit PresetTrial(Rule rule) : rule_(rule) {}

  /// Adds the iterations of a step, `failed` if an attempt at it had failed. True if other options shall take
  /// their turn, as multigrid() and fill() then say.
  bool turns(int newton, int krylov, bool failed = false) {
    const bool counts = !failed || state_.since_failure < seldom;
    state_.since_failure = failed ? 0 : std::min(state_.since_failure + 1, seldom);
    if (!counts) return false;
    state_.newton += newton;
    state_.krylov += krylov;
    if (state_.newton < window) return false;
    iterations_ = static_cast<double>(state_.krylov) / state_.newton;
    state_.newton = state_.krylov = 0;
    if (!state_.multigrid && fill_changes()) return true;
    ++state_.windows;
    if (state_.multigrid ? multigrid_pays() : !multigrid_may_pay()) return false;
    (state_.multigrid ? state_.with_multigrid : state_.with_first) = iterations_;
    state_.returns += state_.multigrid ? 1 : 0;
    state_.multigrid = !state_.multigrid;
    state_.windows = 0;
    return true;
  }

  bool multigrid() const { return state_.multigrid; }
  int fill() const { return state_.fill; }
  /// Krylov iterations a linear system on which the last decision rests.
  double iterations() const { return iterations_; }
  State& state() { return state_; }

 private:
  /// Two bounds far apart: more fill takes fewer iterations, which must not take it away again.
  bool fill_changes() {
    const int before = state_.fill;
    if (iterations_ > rule_.filling) state_.fill = 1;
    if (iterations_ < rule_.emptying) state_.fill = 0;
    return state_.fill != before;
  }
  bool multigrid_pays() const { return iterations_ <= rule_.paying * state_.with_first; }
  /// After a return only if the first preset takes more now than it did, or after a while.
  bool multigrid_may_pay() const {
    if (iterations_ <= rule_.many) return false;
    return state_.returns == 0 || state_.with_multigrid < rule_.paying * iterations_ ||
           state_.windows >= rule_.patience << std::min(state_.returns - 1, 9);
  }

  Rule rule_;
  State state_;
  double iterations_ = 0;
};

}  // namespace scree

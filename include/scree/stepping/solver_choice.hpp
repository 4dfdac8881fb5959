/// Which preset a run goes on with: counts in, a decision out.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scree/stepping/choices.hpp"

namespace scree {

/// A preset that a run may take, with what it costs. Unit: an iteration of the first of a list.
struct SolverCandidate {
  SolverPreset preset;
  int fill = 0;            ///< levels of fill more than the preset has by itself
  double setup = 0;        ///< cost of a set-up
  double iteration = 0;    ///< cost of a Krylov iteration
  double hoped = 0;        ///< iterations a linear system that it takes where it is the right one
  double renewed = 0;      ///< set-ups a Newton iteration
  bool strongest = false;  ///< the one to go to where another does not solve a linear system
};

/// The presets of a scene, that of its start first. The costs were measured by tests/benchmark on one rank; that of a
/// factor grows with the cells faster than that of a product, and more ranks help it less.
std::vector<SolverCandidate> solver_candidates(bool gas, int dim, double cells, int ranks);

/// Takes the candidate of the least cost a Newton iteration: counted for the one in use, remembered for those that were
/// in use not long ago, hoped of the others. One that has disappointed is asked again after a while, each time twice as
/// long. Counts of iterations are the same on all ranks and in a run that is restarted; seconds are not.
class SolverChoice {
 public:
  static constexpr int window = 10;        ///< Newton iterations for a decision
  static constexpr int seldom = 7;         ///< steps between failures, up to which these count
  static constexpr int patience = 8;       ///< windows for which a cost is remembered
  static constexpr double paying = 0.8;    ///< share of the cost at which a change pays
  static constexpr double failing = 1e30;  ///< the cost of one that has not solved a system
  static constexpr std::size_t most = 4;   ///< candidates

  /// What a checkpoint has to hold.
  struct State {
    int current = 0;
    int newton = 0, krylov = 0, setups = 0;  ///< of the window so far
    int since_failure = seldom;              ///< steps since one of which an attempt failed, `seldom` at most
    std::array<double, most> cost{};         ///< when it was in use last; 0: never was
    std::array<int, most> windows{};         ///< since then
    std::array<int, most> disappointed{};    ///< times in a row that it was left again for another

    /// Calls visit(name, member) for each; the names are those in checkpoints.
    template <class Visitor>
    void each_member(Visitor&& visit) {
      visit("solver_current", current);
      visit("solver_newton", newton);
      visit("solver_krylov", krylov);
      visit("solver_setups", setups);
      visit("solver_since_failure", since_failure);
      for (std::size_t k = 0; k < most; ++k) {
        const std::string end = '_' + std::to_string(k);
        visit(("solver_cost" + end).c_str(), cost[k]);
        visit(("solver_windows" + end).c_str(), windows[k]);
        visit(("solver_disappointed" + end).c_str(), disappointed[k]);
      }
    }
  };

  explicit SolverChoice(std::vector<SolverCandidate> candidates) : candidates_(std::move(candidates)) {}

  const SolverCandidate& current() const { return candidates_[static_cast<std::size_t>(state_.current)]; }
  State& state() { return state_; }
  /// Krylov iterations a linear system on which the last decision rests.
  double iterations() const { return iterations_; }

  /// Adds the counts of a step, `failed` if an attempt at it had failed: what these took says nothing of the preset,
  /// unless steps fail often. True if current() is another from here on.
  bool turns(int newton, int krylov, int setups, bool failed = false) {
    const bool counts = !failed || state_.since_failure < seldom;
    state_.since_failure = failed ? 0 : std::min(state_.since_failure + 1, seldom);
    if (!counts) return false;
    state_.newton += newton;
    state_.krylov += krylov;
    state_.setups += setups;
    if (state_.newton < window) return false;
    iterations_ = static_cast<double>(state_.krylov) / state_.newton;
    const double cost = (current().setup * state_.setups + current().iteration * state_.krylov) / state_.newton;
    state_.newton = state_.krylov = state_.setups = 0;
    for (int& windows : state_.windows) ++windows;
    remember(state_.current, cost);
    const int other = cheapest_other();
    if (other < 0 || expected(other) >= paying * cost) {
      state_.disappointed[static_cast<std::size_t>(state_.current)] = 0;
      return false;
    }
    leave(other);
    return true;
  }

  /// A linear system was not solved. True if current() is a stronger one from here on.
  bool strengthens() {
    if (current().strongest) return false;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      if (!candidates_[k].strongest) continue;
      remember(state_.current, failing);
      state_.newton = state_.krylov = state_.setups = 0;
      leave(static_cast<int>(k));
      return true;
    }
    return false;
  }

 private:
  void remember(int candidate, double cost) {
    const auto k = static_cast<std::size_t>(candidate);
    state_.cost[k] = cost;
    state_.windows[k] = 0;
  }
  void leave(int other) {
    int& times = state_.disappointed[static_cast<std::size_t>(state_.current)];
    times = std::min(times + 1, 9);
    state_.current = other;
  }
  int cheapest_other() const {
    int best = -1;
    for (int k = 0; k < static_cast<int>(candidates_.size()); ++k)
      if (k != state_.current && (best < 0 || expected(k) < expected(best))) best = k;
    return best;
  }
  double expected(int candidate) const {
    const auto k = static_cast<std::size_t>(candidate);
    const SolverCandidate& c = candidates_[k];
    const bool remembered = state_.cost[k] > 0 && state_.windows[k] < patience << state_.disappointed[k];
    return remembered ? state_.cost[k] : c.setup * c.renewed + c.iteration * c.hoped;
  }

  std::vector<SolverCandidate> candidates_;
  State state_;
  double iterations_ = 0;
};

}  // namespace scree

/// Means of the unknowns over time.
#pragma once

#include <petscdmda.h>

namespace scree {

/// Sums up states, each weighted by the step that led to it.
class TimeAverage {
 public:
  /// Collective. Counts what lies after `from` [s].
  TimeAverage(DM dm, double from);
  ~TimeAverage();
  TimeAverage(const TimeAverage&) = delete;
  TimeAverage& operator=(const TimeAverage&) = delete;

  /// Adds a step of `dt` that ended at `time` with `state`; the part of it before `from` does not count.
  void add(double time, double dt, Vec state);
  bool empty() const { return seconds_ <= 0; }
  /// The mean so far, until the next call of a method; not for an empty one. Borrowed.
  Vec mean();

  // For checkpoints.
  Vec sum() const { return sum_; }
  template <class Visit>
  void each_member(Visit&& visit) {
    visit("average_seconds", seconds_);
  }

 private:
  double from_, seconds_ = 0;
  Vec sum_ = nullptr, mean_ = nullptr;
};

}  // namespace scree

/// The times at which something is written: whole multiples of an interval.
#pragma once

namespace scree {

/// Multiples of `interval` after `time` [s]; an interval of 0 has none. Times that differ by less than a millionth of
/// the interval count as the same, so that no step is made of rounding errors.
class OutputTimes {
 public:
  explicit OutputTimes(double interval = 0, double time = 0);

  double next() const { return next_; }  ///< infinite where there is none
  bool due(double time) const { return time >= next_ - slack_; }
  /// What was due at `time` has been done.
  void pass(double time);

 private:
  double interval_, slack_, next_ = 0;
};

}  // namespace scree

#include "scree/output/output_times.hpp"

#include <cmath>
#include <limits>

namespace scree {

OutputTimes::OutputTimes(double interval, double time) : interval_(interval), slack_(1e-6 * interval) { pass(time); }

void OutputTimes::pass(double time) {
  next_ = interval_ > 0 ? interval_ * (std::floor((time + slack_) / interval_) + 1)
                        : std::numeric_limits<double>::infinity();
}

}  // namespace scree

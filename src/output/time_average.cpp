#include "scree/output/time_average.hpp"

#include <algorithm>

#include "scree/output/errors.hpp"

namespace scree {

TimeAverage::TimeAverage(DM dm, double from) : from_(from) {
  check_petsc(DMCreateGlobalVector(dm, &sum_), "time average");
  check_petsc(VecDuplicate(sum_, &mean_), "time average");
}

TimeAverage::~TimeAverage() {
  (void)VecDestroy(&sum_);
  (void)VecDestroy(&mean_);
}

void TimeAverage::add(double time, double dt, Vec state) {
  const double counted = std::min(dt, time - from_);
  if (counted <= 0) return;
  check_petsc(VecAXPY(sum_, counted, state), "time average");
  seconds_ += counted;
}

Vec TimeAverage::mean() {
  check_petsc(VecCopy(sum_, mean_), "time average");
  check_petsc(VecScale(mean_, 1 / seconds_), "time average");
  return mean_;
}

}  // namespace scree

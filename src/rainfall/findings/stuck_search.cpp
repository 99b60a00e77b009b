#include "rainfall/findings/stuck_search.h"

#include <algorithm>
#include <limits>

namespace thiessen {

void StuckSearch::see(const SeenStep& step, const TakeFinding& take) {
  ++step_;
  times_[step_ % equal_] = step.time;
  if (step.follows) {
    for (const StationIndex gauge : step.wet) {
      if (step.readings[index(gauge)] == before_[index(gauge)]) go_on(gauge, step, take);
    }
  }
  std::copy(step.readings.begin(), step.readings.end(), before_.begin());
}

void StuckSearch::go_on(StationIndex gauge, const SeenStep& step, const TakeFinding& take) {
  Run& run = runs_[index(gauge)];
  run = {step_, run.last + 1 == step_ ? run.steps + 1 : 2};
  if (run.steps < equal_) return;
  const std::size_t first = run.steps == equal_ ? step_ + 1 - equal_ : step_;
  for (std::size_t at = first; at <= step_; ++at) {
    take({gauge, FindingKind::stuck, times_[at % equal_], step.readings[index(gauge)],
          std::numeric_limits<double>::quiet_NaN()});
  }
}

}  // namespace thiessen

#include "readings/steps/usual_step.h"

#include "rainfall/series/step_length.h"

namespace thiessen {
namespace {

constexpr std::size_t most_intervals = 1000;

}  // namespace

void UsualStep::Intervals::note(std::int64_t length) {
  if (length <= 0) return;
  if (counts.size() >= most_intervals && !counts.contains(length)) return;
  const std::size_t count = ++counts[length];
  if (count < times_usual || (count == times_usual && length >= usual)) return;
  usual = length;
  times_usual = count;
}

void UsualStep::note(const IsoTime& time) {
  if (last_) {
    ++intervals_;
    seconds_.note(moment_seconds(time) - moment_seconds(*last_));
    if (stand_alike_in_months(*last_, time))
      months_.note(month_number(time) - month_number(*last_));
  }
  last_ = time;
}

bool UsualStep::lacks_between(const IsoTime& before, const IsoTime& after) const {
  const auto is_usual = [&](const Intervals& one) {
    return one.times_usual > 0 && 2 * one.times_usual >= intervals_;
  };
  if (is_usual(months_)) return month_number(after) - month_number(before) >= 2 * months_.usual;
  if (!is_usual(seconds_)) return false;
  return moment_seconds(after) - moment_seconds(before) >= 2 * seconds_.usual;
}

}  // namespace thiessen

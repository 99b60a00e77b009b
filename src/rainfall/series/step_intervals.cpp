#include "rainfall/series/step_intervals.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace thiessen {
namespace {

constexpr std::size_t most_intervals = 1000;

std::string month_text(std::int64_t month) {
  IsoTime time;
  time.year = static_cast<int>(month / 12);
  time.month = static_cast<int>(month % 12) + 1;
  return date_text(time, TimePrecision::month);
}

}  // namespace

void StepIntervals::note(const ParsedTime& time) {
  ++times_;
  labels_ = labels_ || !time;
  if (labels_) return;
  const std::optional<IsoTime> before = before_;
  before_ = time.time;
  if (!before) return;
  const std::int64_t from = moment_seconds(*before);
  const std::int64_t to = moment_seconds(time.time);
  ascends_ = ascends_ || to > from;
  descends_ = descends_ || to < from;
  enter(seconds_, from, to);
  if (stand_alike_in_months(*before, time.time))
    enter(months_, month_number(*before), month_number(time.time));
  too_many_ = too_many_ || seconds_.size() > most_intervals;
  if (too_many_) seconds_.clear();
}

void StepIntervals::enter(Intervals& intervals, std::int64_t from, std::int64_t to) {
  const auto [earlier, later] = std::minmax(from, to);
  if (earlier == later) return;
  const auto [at, fresh] = intervals.try_emplace(later - earlier);
  Interval& interval = at->second;
  interval.first = fresh ? earlier : std::min(interval.first, earlier);
  interval.last = fresh ? later : std::max(interval.last, later);
  ++interval.count;
}

/// The longest interval of which nine in ten of the file's intervals are multiples.
std::optional<std::int64_t> StepIntervals::common(const Intervals& intervals) const {
  const std::size_t all = times_ - 1;
  for (auto one = intervals.rbegin(); one != intervals.rend(); ++one) {
    std::size_t multiples = 0;
    for (const auto& [length, interval] : intervals)
      multiples += length % one->first == 0 ? interval.count : 0;
    if (10 * multiples >= 9 * all) return one->first;
  }
  return std::nullopt;
}

std::optional<StepLength> StepIntervals::step() const {
  if (labels_ || too_many_ || times_ < 2) return std::nullopt;
  if (const auto months = common(months_)) return StepLength{*months, 0};
  if (const auto seconds = common(seconds_)) return StepLength{0, *seconds};
  return std::nullopt;
}

std::optional<StepIntervals::Lacking> StepIntervals::lacking(const StepLength& step) const {
  if (ascends_ && descends_) return std::nullopt;
  const bool by_months = step.months > 0;
  const std::int64_t length = by_months ? step.months : step.seconds;
  std::int64_t first = std::numeric_limits<std::int64_t>::max();
  std::int64_t last = std::numeric_limits<std::int64_t>::min();
  Lacking found;
  for (const auto& [between, interval] : by_months ? months_ : seconds_) {
    const auto lack = static_cast<std::size_t>(between / length - (between % length == 0 ? 1 : 0));
    if (lack == 0) continue;
    found.steps += lack * interval.count;
    first = std::min(first, interval.first);
    last = std::max(last, interval.last);
  }
  if (found.steps == 0) return found;
  const TimePrecision precision =
      before_->precision == TimePrecision::instant ? TimePrecision::instant : TimePrecision::day;
  const auto text = [&](std::int64_t at) {
    return by_months ? month_text(at) : time_text(at, precision);
  };
  found.first = text(first + length);
  found.last = text(last - length);
  return found;
}

}  // namespace thiessen

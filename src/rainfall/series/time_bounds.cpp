#include "rainfall/series/time_bounds.h"

#include <algorithm>
#include <cstdint>

namespace thiessen {
namespace {

double seconds_of(const IsoTime& time) {
  return static_cast<double>(moment_seconds(time)) + time.nanosecond * 1e-9;
}

std::optional<StepLength> length_of(TimePrecision precision) {
  switch (precision) {
    case TimePrecision::year:
      return StepLength{12, 0};
    case TimePrecision::month:
      return StepLength{1, 0};
    case TimePrecision::day:
      return StepLength{0, seconds_of_day};
    case TimePrecision::instant:
      return std::nullopt;
  }
  return std::nullopt;
}

/// The first of the sorted times that is later; without one the time moved on by the last gap.
double end_of_moment(double begin, std::span<const double> sorted) {
  const auto next = std::upper_bound(sorted.begin(), sorted.end(), begin);
  if (next != sorted.end()) return *next;
  const auto before = std::lower_bound(sorted.begin(), sorted.end(), begin);
  return before == sorted.begin() ? begin : begin + (begin - *(before - 1));
}

/// The last of the sorted times that is earlier; without one the time moved back by the next gap.
double begin_of_moment(double end, std::span<const double> sorted) {
  const auto at = std::lower_bound(sorted.begin(), sorted.end(), end);
  if (at != sorted.begin()) return *(at - 1);
  const auto next = std::upper_bound(sorted.begin(), sorted.end(), end);
  return next == sorted.end() ? end : end - (*next - end);
}

/// The bounds of a step that ends at a moment.
TimeBounds until(const IsoTime& time, const std::optional<StepLength>& step,
                 std::span<const double> sorted) {
  const double end = seconds_of(time);
  if (!step) return {begin_of_moment(end, sorted), end};
  if (step->months != 0) return {seconds_of(months_later(time, -step->months)), end};
  return {end - static_cast<double>(step->seconds), end};
}

}  // namespace

std::vector<TimeBounds> bounds_of(std::span<const IsoTime> times,
                                  const std::optional<StepLength>& step, Stamp stamp) {
  std::vector<double> sorted;
  sorted.reserve(times.size());
  for (const IsoTime& time : times) sorted.push_back(seconds_of(time));
  std::sort(sorted.begin(), sorted.end());
  std::vector<TimeBounds> bounds;
  bounds.reserve(times.size());
  for (const IsoTime& time : times) {
    if (stamp == Stamp::end && time.precision == TimePrecision::instant) {
      bounds.push_back(until(time, step, sorted));
      continue;
    }
    const std::optional<StepLength> length = step ? step : length_of(time.precision);
    const double begin = seconds_of(time);
    if (!length) {
      bounds.push_back({begin, end_of_moment(begin, sorted)});
    } else if (length->months != 0) {
      bounds.push_back({begin, seconds_of(months_later(time, length->months))});
    } else {
      bounds.push_back({begin, begin + static_cast<double>(length->seconds)});
    }
  }
  return bounds;
}

}  // namespace thiessen

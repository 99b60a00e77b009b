#include "rainfall/series/step_depths.h"

#include <cstdint>

namespace thiessen {
namespace {

/// The seconds of a month counted as month_number does, and of those that follow it.
std::int64_t seconds_of_months(std::int64_t first, std::int64_t count) {
  const auto begin_of = [](std::int64_t number) {
    IsoTime time;
    time.precision = TimePrecision::month;
    time.year = static_cast<int>(number / 12);
    time.month = static_cast<int>(number % 12) + 1;
    return clock_seconds(time);
  };
  return begin_of(first + count) - begin_of(first);
}

}  // namespace

Error rates_without_step(const std::string& file, const std::string& unit, const std::string& why) {
  return Error(Message{
      file, 0,
      "the readings are rates in " + unit + ", whose totals want the length of each step, and " +
          why,
      setting("scale") +
          " by that length makes depths of them (0.25 of mm/h in steps of 15 minutes); where they "
          "are depths, " +
          setting("from_unit", "mm") + " says so"});
}

double StepDepths::of(double value, const IsoTime& within, Stamp stamp) const {
  if (are_the_values()) return value;
  const bool ends = stamp == Stamp::end && within.precision == TimePrecision::instant;
  std::int64_t times = step_.seconds;
  std::int64_t parts = rate_.seconds;
  if (step_.months > 0 && rate_.months > 0) {
    times = step_.months;
    parts = rate_.months;
  } else if (step_.months > 0) {
    const std::int64_t before = ends ? step_.months - 1 : 0;
    times = seconds_of_months(month_number(within) - before, step_.months);
  } else if (rate_.months > 0) {
    const std::int64_t month = month_number(within);
    parts = seconds_of_months(month - month % rate_.months, rate_.months);
  }
  return value * static_cast<double>(times) / static_cast<double>(parts);
}

}  // namespace thiessen

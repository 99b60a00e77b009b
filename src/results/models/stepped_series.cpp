#include "results/models/stepped_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/calendar_days.h"
#include "base/number.h"

namespace thiessen {
namespace {

constexpr const char* any_steps = "a CSV, a NetCDF and a PI-XML take any steps";

constexpr double none = std::numeric_limits<double>::quiet_NaN();

bool has_clock(const IsoTime& time) {
  return time.precision == TimePrecision::instant;
}

/// A moment for a message, as a date where it is midnight.
std::string moment_text(std::int64_t seconds) {
  return time_text(seconds,
                   seconds % seconds_of_day == 0 ? TimePrecision::day : TimePrecision::instant);
}

}  // namespace

SteppedSeries::SteppedSeries(ModelSubject subject, std::string format)
    : subject_(std::move(subject)),
      format_(std::move(format)),
      times_(subject_.rainfall, format_, subject_.step),
      held_(subject_.basins.size()) {}

void SteppedSeries::add(const IsoTime& time, std::span<const double> rainfall,
                        std::span<const double> /*errors*/) {
  times_.note(time);
  if (time.nanosecond != 0) {
    throw Error({subject_.rainfall, 0,
                 "the time " + iso_text(time) + " is told to fractions of a second, and " +
                     format_ + " has whole ones",
                 "a CSV takes any times"});
  }
  if (has_clock(time) != has_clock(times_.first())) {
    throw Error({subject_.rainfall, 0,
                 "some times have a clock and others have none, and " + format_ +
                     " wants steps of one length",
                 "a CSV takes any times"});
  }
  const std::int64_t moment = times_.seconds_of(time);
  if (held_.count() > 0 && moment <= last_) {
    throw Error({subject_.rainfall, 0,
                 "the time " + iso_text(time) + " does not come after the one before it, and " +
                     format_ + " wants them in their order",
                 "sort the rows by their times"});
  }
  last_ = moment;
  held_.add(moment, rainfall);
}

void SteppedSeries::finish(Warnings& warnings) {
  if (held_.count() == 0) throw Error({subject_.rainfall, 0, "there is no time step to write", ""});
  write(steps(), warnings);
}

/// Which place among the steps a moment has.
std::size_t SteppedSeries::place_of(std::int64_t moment, const Steps& steps) const {
  const bool ends = subject_.stamp == Stamp::end && has_clock(times_.first());
  const std::int64_t since = moment - (ends ? steps.length : 0) - steps.begin;
  if (since % steps.length != 0) {
    throw Error({subject_.rainfall, 0,
                 "the step at " + moment_text(moment) + " is out of line with steps of " +
                     thiessen::text_of(StepLength{0, steps.length}) + ", and " + format_ +
                     " wants steps of one length",
                 setting("every", "day") + " sums them by day; a CSV takes any times"});
  }
  return static_cast<std::size_t>(since / steps.length);
}

SteppedSeries::Steps SteppedSeries::steps() {
  const std::optional<StepLength> length = times_.step();
  const bool is_even = length && length->months == 0;
  Steps steps;
  steps.count = held_.count();
  if (!is_even && takes_any_steps()) return steps;
  if (!length) {
    throw Error({subject_.rainfall, 0,
                 held_.count() == 1
                     ? "nothing tells how long its only step is, and " + format_ + " wants that"
                     : "its times have no regular step, and " + format_ + " wants one",
                 setting("every", "day") + " sums them by day"});
  }
  if (!is_even) {
    throw Error({subject_.rainfall, 0,
                 "its steps are of " + thiessen::text_of(*length) + ", and " + format_ +
                     " wants steps of one length",
                 any_steps});
  }
  steps.length = length->seconds;
  const bool ends = subject_.stamp == Stamp::end && has_clock(times_.first());
  steps.begin = times_.seconds_of(times_.first()) - (ends ? steps.length : 0);
  std::size_t next = 0;
  held_.by_step([&](std::int64_t moment, std::span<const double>) {
    const std::size_t place = place_of(moment, steps);
    if (place > next && steps.lacking == 0)
      steps.first_lacking =
          moment_text(steps.begin + static_cast<std::int64_t>(next) * steps.length);
    steps.lacking += place - next;
    next = place + 1;
  });
  steps.count = next;
  return steps;
}

void SteppedSeries::require_parts_of_days(const Steps& steps) const {
  const bool is_part = steps.length <= seconds_of_day && seconds_of_day % steps.length == 0;
  if (!is_part || steps.length % 60 != 0) {
    throw Error({subject_.rainfall, 0,
                 "its steps are of " + thiessen::text_of(StepLength{0, steps.length}) + ", and " +
                     format_ + " wants a day, or a part of it in whole minutes",
                 steps.length < seconds_of_day ? setting("every", "day") + " sums them by day"
                                               : Wording(any_steps)});
  }
  const std::int64_t after_midnight =
      ((steps.begin % seconds_of_day) + seconds_of_day) % seconds_of_day;
  const bool has_date = after_midnight == 0 || after_midnight == subject_.day_start;
  if (after_midnight % 60 == 0 && (steps.length < seconds_of_day || has_date)) return;
  throw Error({subject_.rainfall, 0,
               "its steps begin at " + moment_text(steps.begin) + ", and " + format_ +
                   (steps.length < seconds_of_day ? " wants whole minutes" : " has dates for days"),
               setting("every", "day") + " dates each by the day in which it begins"});
}

void SteppedSeries::require_unit(std::span<const std::string_view> units) const {
  if (std::find(units.begin(), units.end(), subject_.unit) != units.end()) return;
  const bool is_rate = subject_.unit.find('/') != std::string::npos;
  throw Error({subject_.rainfall, 0,
               "the readings are in " + subject_.unit + ", and " + format_ + " wants " +
                   std::string(units.front()),
               is_rate ? Wording("what falls in a step is wanted, and this is a rate")
                       : setting("to_unit", units.front()) + " brings them to it"});
}

void SteppedSeries::tell_zone(Warnings& warnings) const {
  if (!times_.zone()) return;
  warnings.add_notice(
      {subject_.output, 0,
       format_ + " has no time zone: its times are by the clock of " + zone_text(*times_.zone()),
       ""});
}

void SteppedSeries::tell_lacking(const Steps& steps, const std::string& missing,
                                 Warnings& warnings) const {
  if (steps.lacking == 0) return;
  warnings.add({subject_.rainfall, 0,
                std::to_string(steps.lacking) +
                    (steps.lacking == 1 ? " step lacks" : " steps lack") + " between others, " +
                    (steps.lacking == 1 ? "at " : "the first at ") + steps.first_lacking + ": " +
                    missing + " stands there",
                ""});
}

void SteppedSeries::by_step(const Steps& steps, const TakeStep& take) {
  const std::vector<double> nothing(subject_.basins.size(), none);
  std::size_t next = 0;
  const auto begin_of = [&](std::size_t place) {
    return steps.begin + static_cast<std::int64_t>(place) * steps.length;
  };
  held_.by_step([&](std::int64_t moment, std::span<const double> rainfall) {
    const std::size_t place = place_of(moment, steps);
    for (; next < place; ++next) take(begin_of(next), nothing);
    take(begin_of(next++), rainfall);
  });
}

void SteppedSeries::by_basin(const Steps& steps, const HeldSteps::TakeBasin& take) {
  if (steps.lacking == 0) return held_.by_basin(take);
  std::vector<std::size_t> places;
  held_.by_step([&](std::int64_t moment, std::span<const double>) {
    places.push_back(place_of(moment, steps));
  });
  std::vector<double> values(steps.count, none);
  held_.by_basin([&](std::size_t basin, std::span<const double> known) {
    for (std::size_t i = 0; i < known.size(); ++i) values[places[i]] = known[i];
    take(basin, values);
  });
}

void SteppedSeries::append_value(std::string& text, double value, std::string_view missing) const {
  if (std::isnan(value)) {
    text += missing;
  } else {
    append_fixed(text, value, subject_.decimals);
  }
}

}  // namespace thiessen

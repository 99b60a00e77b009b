#include "readings/totals/total_periods.h"

#include "base/calendar_days.h"
#include "base/utf8.h"
#include "rainfall/series/step_length.h"

namespace thiessen {
namespace {

/// The day of a time's date, counted from the first of January 1970.
std::int64_t day_of(const IsoTime& date) {
  return first_day_of_month(month_number(date)) + date.day - 1;
}

std::int64_t last_day_of_month(std::int64_t month) {
  return first_day_of_month(month + 1) - 1;
}

bool has_clock(const IsoTime& time) {
  return time.precision == TimePrecision::instant;
}

bool is_midnight(const IsoTime& time) {
  return time.hour % 24 == 0 && time.minute == 0 && time.second == 0 && time.nanosecond == 0;
}

}  // namespace

bool TotalPeriods::is_by_clock(const IsoTime& time) const {
  return !has_clock(time) || hour_.minutes.has_value();
}

TotalPeriod TotalPeriods::of(const IsoTime& time, int days, const std::string& text,
                             const std::string& file, std::size_t line) const {
  const std::string shown = "total of " + quoted(text, 80);
  if (is_by_clock(time)) {
    if (!hour_.minutes) {
      throw Error({file, line, "the " + shown + " has no hour, and nothing says when it was read",
                   setting("observed_at", "09:00") + " says that totals are read at 9, and " +
                       setting("observed_at", "24:00") + " that they are of whole days"});
    }
    if (has_clock(time) && !is_midnight(time)) {
      throw Error({file, line,
                   "the " + shown + " has an hour of its own, and " + setting("observed_at") +
                       " says another",
                   "leave it out: " + setting("stamp") +
                       " says whether times of totals begin or end them"});
    }
    return of_date(time, days, *hour_.minutes);
  }
  if (!step_) {
    throw Error({file, line,
                 "nothing tells how long the " + shown + " is, for the totals have no regular step",
                 setting("observed_at") + " takes totals whose clock is 00:00 for those of a day"});
  }
  return of_moment(time, days, *step_);
}

TotalPeriod TotalPeriods::of_date(const IsoTime& time, int days, int minutes) const {
  std::int64_t last = day_of(time);
  if (time.precision == TimePrecision::month) last = last_day_of_month(month_number(time));
  if (time.precision == TimePrecision::year) last = last_day_of_month(month_number(time) + 11);
  if (has_clock(time) && time.hour == 24) ++last;
  std::int64_t first = last;
  if (days > 0) {
    first = last - days + 1;
  } else if (time.precision < TimePrecision::day) {
    first = first_day_of_month(month_number(time));
  } else if (step_ && step_->months > 0) {
    first = day_of(months_later(time, -step_->months)) + 1;
  } else if (step_ && step_->seconds > seconds_of_day) {
    first = last - step_->seconds / seconds_of_day + 1;
  }
  const std::int64_t later =
      (hour_.is_dated_before ? 0 : -seconds_of_day) + std::int64_t{60} * minutes;
  return {first * seconds_of_day + later, (last + 1) * seconds_of_day + later};
}

TotalPeriod TotalPeriods::of_moment(const IsoTime& time, int days, const StepLength& step) const {
  const std::int64_t at = moment_seconds(time);
  TotalPeriod period{at, at};
  if (hour_.stamp == Stamp::begin) {
    period.end =
        step.months > 0 ? moment_seconds(months_later(time, step.months)) : at + step.seconds;
  } else {
    period.begin =
        step.months > 0 ? moment_seconds(months_later(time, -step.months)) : at - step.seconds;
  }
  if (days > 0) period.begin = period.end - days * seconds_of_day;
  return period;
}

}  // namespace thiessen

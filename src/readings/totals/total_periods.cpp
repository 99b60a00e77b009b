#include "readings/totals/total_periods.h"

#include <algorithm>
#include <chrono>

#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::int64_t day = 86'400;

/// The number of a day of the calendar, counted from the beginning of 1970.
std::int64_t day_number(int year, int month, int of_month) {
  return std::chrono::sys_days(std::chrono::year(year) /
                               std::chrono::month(static_cast<unsigned>(month)) /
                               std::chrono::day(static_cast<unsigned>(of_month)))
      .time_since_epoch()
      .count();
}

std::int64_t last_day_of_month(std::int64_t month) {
  const std::int64_t next = month + 1;
  return day_number(static_cast<int>(next / 12), static_cast<int>(next % 12) + 1, 1) - 1;
}

/// The same day so many months before: the last one where the month has no such day, or where it
/// was the last.
std::int64_t months_before(const IsoTime& time, std::int64_t months) {
  const std::int64_t month = month_number(time) - months;
  const std::int64_t last = last_day_of_month(month);
  if (is_last_of_month(time)) return last;
  return std::min(last, last_day_of_month(month - 1) + time.day);
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
  std::int64_t last = day_number(time.year, time.month, time.day);
  if (time.precision == TimePrecision::month) last = last_day_of_month(month_number(time));
  if (time.precision == TimePrecision::year) last = last_day_of_month(month_number(time) + 11);
  if (has_clock(time) && time.hour == 24) ++last;
  std::int64_t first = last;
  if (days > 0) {
    first = last - days + 1;
  } else if (time.precision < TimePrecision::day) {
    first = day_number(time.year, time.month, 1);
  } else if (step_ && step_->months > 0) {
    first = months_before(time, step_->months) + 1;
  } else if (step_ && step_->seconds > day) {
    first = last - step_->seconds / day + 1;
  }
  const std::int64_t later = (hour_.is_dated_before ? 0 : -day) + std::int64_t{60} * minutes;
  return {first * day + later, (last + 1) * day + later};
}

TotalPeriod TotalPeriods::of_moment(const IsoTime& time, int days, const StepLength& step) const {
  const std::int64_t at = moment_seconds(time);
  TotalPeriod period{at, at};
  if (hour_.stamp == Stamp::begin) {
    if (step.months > 0) {
      IsoTime later = time;
      const std::int64_t month = month_number(time) + step.months;
      const std::int64_t last = last_day_of_month(month) - last_day_of_month(month - 1);
      later.year = static_cast<int>(month / 12);
      later.month = static_cast<int>(month % 12) + 1;
      later.day = is_last_of_month(time) ? static_cast<int>(last)
                                         : std::min(time.day, static_cast<int>(last));
      period.end = moment_seconds(later);
    } else {
      period.end = at + step.seconds;
    }
  } else if (step.months > 0) {
    const std::int64_t date = day_number(time.year, time.month, time.day);
    period.begin = at - (date - months_before(time, step.months)) * day;
  } else {
    period.begin = at - step.seconds;
  }
  if (days > 0) period.begin = period.end - days * day;
  return period;
}

}  // namespace thiessen

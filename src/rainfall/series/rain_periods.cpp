#include "rainfall/series/rain_periods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "rainfall/series/dated_readings.h"

namespace thiessen {
namespace {

/// A number for a period, which differs for different periods of one length.
int number_of(const IsoTime& time, TimePrecision every) {
  const int month = every >= TimePrecision::month ? time.month : 0;
  const int day = every >= TimePrecision::day ? time.day : 0;
  return (time.year * 16 + month) * 32 + day;
}

}  // namespace

RainPeriods::RainPeriods(Totalling totalling, std::string file, Take take)
    : totalling_(totalling), file_(std::move(file)), take_(std::move(take)) {}

void RainPeriods::add(const RainStep& step) {
  const IsoTime time = time_of_step(step.time, totalling_.every, file_, step.line);
  if (!begun_.empty() && step.time != text_before_ && time.precision == before_.precision &&
      time.ahead_of_utc == before_.ahead_of_utc && order_of_moments(time, before_) == 0) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, 80) + " is that of the step before, written again",
                 ""});
  }
  before_ = time;
  text_before_ = step.time;
  if (!open_ || order_of_dates(time, first_, totalling_.every) != 0) {
    if (open_) end();
    begin(time, step);
  }
  if (order_of_dates(time, first_, TimePrecision::day) < 0) first_ = time;
  if (order_of_dates(time, last_, TimePrecision::day) > 0) last_ = time;
  for (std::size_t b = 0; b < sums_.size(); ++b) {
    const double rainfall = step.basins[b].rainfall;
    Sum& sum = sums_[b];
    if (std::isnan(rainfall)) {
      ++sum.missing;
    } else {
      ++sum.values;
      sum.rainfall.add(rainfall);
    }
  }
}

void RainPeriods::begin(const IsoTime& time, const RainStep& step) {
  if (!begun_.insert(number_of(time, totalling_.every)).second) {
    throw Error({file_, step.line,
                 "time " + quoted(step.time, 80) + " comes back to " +
                     date_text(time, totalling_.every) + " after another period has begun",
                 "sort the file by time"});
  }
  first_ = last_ = time;
  sums_.assign(step.basins.size(), Sum{});
  open_ = true;
}

bool RainPeriods::is_partial() const {
  using std::chrono::month;
  using std::chrono::year;
  const TimePrecision steps = std::min(first_.precision, TimePrecision::day);
  const auto year_begins = first_.month == 1 && last_.month == 12;
  if (totalling_.every < TimePrecision::month && steps >= TimePrecision::month && !year_begins)
    return true;
  if (totalling_.every == TimePrecision::day || steps < TimePrecision::day) return false;
  const auto last_day = std::chrono::year_month_day_last(
      year{last_.year} / month{static_cast<unsigned>(last_.month)} / std::chrono::last);
  return first_.day != 1 ||
         static_cast<unsigned>(last_.day) != static_cast<unsigned>(last_day.day());
}

void RainPeriods::end() {
  RainPeriod period{date_text(first_, totalling_.every), {}};
  for (const Sum& sum : sums_) period.basins.push_back(total_of(sum));
  open_ = false;
  if (is_partial() && ++partial_ == 1) {
    const TimePrecision steps = std::min(first_.precision, TimePrecision::day);
    first_partial_ = period.time + ", with steps from " + date_text(first_, steps) + " to " +
                     date_text(last_, steps);
  }
  take_(period);
}

void RainPeriods::finish(Warnings& warnings) {
  if (open_) end();
  if (partial_ == 0) return;
  const std::string subject =
      partial_ == 1 ? "a period lacks steps at its beginning or end: "
                    : std::to_string(partial_) +
                          " periods lack steps at their beginning or end, the first is ";
  warnings.add(
      {file_, 0, subject + first_partial_ + "; totals are of the steps that there are", ""});
}

BasinTotal RainPeriods::total_of(const Sum& sum) const {
  const bool has_total = sum.values > 0 && sum.missing <= totalling_.allowed_missing;
  return {has_total ? sum.rainfall.value() : std::numeric_limits<double>::quiet_NaN(), sum.missing};
}

}  // namespace thiessen

#include "rainfall/rain_periods.h"

#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "rainfall/dated_readings.h"

namespace thiessen {
namespace {

/// Different for different periods of one length.
int number_of(const IsoTime& time, TimePrecision every) {
  const int month = every >= TimePrecision::month ? time.month : 0;
  const int day = every >= TimePrecision::day ? time.day : 0;
  return (time.year * 16 + month) * 32 + day;
}

}  // namespace

RainPeriods::RainPeriods(Totalling totalling, std::string file, Take take)
    : totalling_(totalling), file_(std::move(file)), take_(std::move(take)) {}

void RainPeriods::add(const RainStep& step) {
  const IsoTime time = time_of_step(step.time, totalling_.every, file_, 0);
  if (!open_ || order_of_dates(time, period_, totalling_.every) != 0) {
    finish();
    begin(time, step.time, step.basins.size());
  }
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

void RainPeriods::begin(const IsoTime& time, const std::string& text, std::size_t basins) {
  if (!begun_.insert(number_of(time, totalling_.every)).second) {
    throw Error({file_, 0,
                 "time " + quoted(text, 80) + " comes back to " +
                     date_text(time, totalling_.every) + " after another period has begun",
                 "sort the file by time"});
  }
  period_ = time;
  sums_.assign(basins, Sum{});
  open_ = true;
}

void RainPeriods::finish() {
  if (!open_) return;
  RainPeriod period{date_text(period_, totalling_.every), {}};
  for (const Sum& sum : sums_) period.basins.push_back(total_of(sum));
  open_ = false;
  take_(period);
}

BasinTotal RainPeriods::total_of(const Sum& sum) const {
  const bool has_total = sum.values > 0 && sum.missing <= totalling_.allowed_missing;
  return {has_total ? sum.rainfall.value() : std::numeric_limits<double>::quiet_NaN(), sum.missing};
}

}  // namespace thiessen

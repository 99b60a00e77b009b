#include "rainfall/series/time_range.h"

namespace thiessen {
namespace {

std::strong_ordering order_at(const IsoTime& time, const IsoTime& limit) {
  return limit.precision == TimePrecision::instant ? order_of_moments(time, limit)
                                                   : order_of_dates(time, limit, limit.precision);
}

}  // namespace

bool TimeRange::holds(const IsoTime& time) const {
  return (!from || order_at(time, *from) >= 0) && (!to || order_at(time, *to) <= 0);
}

bool TimeRange::is_empty() const {
  return from && to && order_at(*from, *to) > 0;
}

}  // namespace thiessen

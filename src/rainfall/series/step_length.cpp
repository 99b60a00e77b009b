#include "rainfall/series/step_length.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "base/counted.h"

namespace thiessen {
namespace {

struct Unit {
  std::int64_t length;
  const char* name;
};

std::string counted_in(std::int64_t length, const Unit& unit) {
  return counted(static_cast<std::size_t>(length / unit.length), unit.name);
}

}  // namespace

bool is_last_of_month(const IsoTime& time) {
  return time.day == days_in_month(month_number(time));
}

IsoTime months_later(const IsoTime& time, std::int64_t months) {
  const std::int64_t month = month_number(time) + months;
  IsoTime later = time;
  later.year = static_cast<int>(month / 12);
  later.month = static_cast<int>(month % 12 + 1);
  const int last = days_in_month(month);
  later.day = is_last_of_month(time) ? last : std::min(time.day, last);
  return later;
}

std::string text_of(const StepLength& length) {
  constexpr std::array<Unit, 4> clock{
      {{seconds_of_day, "day"}, {3'600, "hour"}, {60, "minute"}, {1, "second"}}};
  if (length.months > 0) {
    return counted_in(length.months, length.months % 12 == 0 ? Unit{12, "year"} : Unit{1, "month"});
  }
  for (const Unit& unit : clock) {
    if (length.seconds % unit.length == 0) return counted_in(length.seconds, unit);
  }
  return {};
}

bool stand_alike_in_months(const IsoTime& a, const IsoTime& b) {
  const auto clock = [](const IsoTime& time) {
    return std::tuple(time.hour, time.minute, time.second, time.nanosecond);
  };
  return clock(a) == clock(b) && (a.day == b.day || (is_last_of_month(a) && is_last_of_month(b)));
}

}  // namespace thiessen

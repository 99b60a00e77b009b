#include "base/iso_time.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace thiessen {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The rest of a text from whose beginning pieces are taken.
class Rest {
 public:
  explicit Rest(std::string_view text) : text_(text) {}

  bool is_empty() const { return text_.empty(); }
  bool begins_with_digit() const { return !text_.empty() && is_digit(text_[0]); }
  bool begins_with(char c) const { return text_.starts_with(c); }
  bool take(char c) {
    if (!begins_with(c)) return false;
    text_.remove_prefix(1);
    return true;
  }
  /// Takes exactly so many digits as a number.
  bool take(int digits, int& number) {
    number = 0;
    for (; digits > 0; --digits) {
      if (!begins_with_digit()) return false;
      number = 10 * number + (text_[0] - '0');
      text_.remove_prefix(1);
    }
    return true;
  }

 private:
  std::string_view text_;
};

bool take_fraction(Rest& rest, int& nanoseconds) {
  if (!rest.take('.') && !rest.take(',')) return true;
  if (!rest.begins_with_digit()) return false;
  for (int unit = 100'000'000; rest.begins_with_digit(); unit /= 10) {
    int digit = 0;
    if (unit == 0 || !rest.take(1, digit)) return false;
    nanoseconds += digit * unit;
  }
  return true;
}

bool take_clock(Rest& rest, bool extended, IsoTime& time) {
  const auto goes_on = [&] { return extended ? rest.take(':') : rest.begins_with_digit(); };
  if (!rest.take(2, time.hour)) return false;
  if (!goes_on()) return true;
  if (!rest.take(2, time.minute)) return false;
  if (!goes_on()) return true;
  return rest.take(2, time.second) && take_fraction(rest, time.nanosecond);
}

struct Zone {
  int hours = 0;
  int minutes = 0;
};

bool take_zone(Rest& rest, IsoTime& time, Zone& zone) {
  if (rest.is_empty()) return true;
  if (rest.take('Z')) {
    time.ahead_of_utc = 0;
    return rest.is_empty();
  }
  const bool behind = rest.begins_with('-');
  if (!rest.take('+') && !rest.take('-')) return false;
  if (!rest.take(2, zone.hours)) return false;
  if (!rest.is_empty()) {
    rest.take(':');
    if (!rest.take(2, zone.minutes)) return false;
  }
  const int minutes = 60 * zone.hours + zone.minutes;
  time.ahead_of_utc = behind ? -minutes : minutes;
  return rest.is_empty();
}

bool take_time(Rest rest, IsoTime& time, Zone& zone) {
  if (!rest.take(4, time.year)) return false;
  if (rest.is_empty()) return true;
  const bool extended = rest.take('-');
  time.precision = TimePrecision::month;
  if (!rest.take(2, time.month)) return false;
  if (rest.is_empty()) return extended;
  time.precision = TimePrecision::day;
  if (extended && !rest.take('-')) return false;
  if (!rest.take(2, time.day)) return false;
  if (rest.is_empty()) return true;
  time.precision = TimePrecision::instant;
  if (!rest.take('T') && !rest.take(' ')) return false;
  return take_clock(rest, extended, time) && take_zone(rest, time, zone);
}

std::chrono::year_month_day day_of(const IsoTime& time) {
  return {std::chrono::year(time.year), std::chrono::month(static_cast<unsigned>(time.month)),
          std::chrono::day(static_cast<unsigned>(time.day))};
}

bool there_is(const IsoTime& time, const Zone& zone) {
  const bool ends_day =
      time.hour == 24 && time.minute == 0 && time.second == 0 && time.nanosecond == 0;
  return day_of(time).ok() && (time.hour < 24 || ends_day) && time.minute < 60 &&
         time.second < 60 && zone.hours < 24 && zone.minutes < 60;
}

/// Appends a number in at least so many digits, with its sign where it is below 0.
void append_digits(std::string& out, int number, std::size_t digits) {
  if (number < 0) out += '-';
  const std::string text = std::to_string(std::abs(number));
  out.append(digits - std::min(digits, text.size()), '0');
  out += text;
}

}  // namespace

ParsedTime parse_iso_time(std::string_view text) {
  IsoTime time;
  Zone zone;
  if (!take_time(Rest(text), time, zone)) return {{}, IsoTimeFault::form};
  if (!there_is(time, zone)) return {{}, IsoTimeFault::value};
  return {time, IsoTimeFault::none};
}

std::int64_t clock_seconds(const IsoTime& time) {
  const std::int64_t days = std::chrono::sys_days(day_of(time)).time_since_epoch().count();
  return ((days * 24 + time.hour) * 60 + time.minute) * 60 + time.second;
}

std::int64_t moment_seconds(const IsoTime& time) {
  return clock_seconds(time) - std::int64_t{60} * time.ahead_of_utc.value_or(0);
}

std::string time_text(std::int64_t seconds, TimePrecision precision) {
  const std::chrono::sys_seconds moment{std::chrono::seconds(seconds)};
  const auto days = std::chrono::floor<std::chrono::days>(moment);
  const std::chrono::year_month_day day(days);
  const std::chrono::hh_mm_ss clock(moment - days);
  IsoTime time;
  time.year = static_cast<int>(day.year());
  time.month = static_cast<int>(static_cast<unsigned>(day.month()));
  time.day = static_cast<int>(static_cast<unsigned>(day.day()));
  std::string text = date_text(time, std::min(precision, TimePrecision::day));
  if (precision != TimePrecision::instant) return text;
  text += 'T';
  append_digits(text, static_cast<int>(clock.hours().count()), 2);
  text += ':';
  append_digits(text, static_cast<int>(clock.minutes().count()), 2);
  if (clock.seconds().count() == 0) return text;
  text += ':';
  append_digits(text, static_cast<int>(clock.seconds().count()), 2);
  return text;
}

std::strong_ordering order_of_moments(const IsoTime& a, const IsoTime& b) {
  const bool zones = a.ahead_of_utc && b.ahead_of_utc;
  const auto moment = [zones](const IsoTime& time) {
    const int ahead = zones ? *time.ahead_of_utc : 0;
    return std::pair(clock_seconds(time) - std::int64_t{60} * ahead, time.nanosecond);
  };
  return moment(a) <=> moment(b);
}

std::strong_ordering order_of_dates(const IsoTime& a, const IsoTime& b, TimePrecision precision) {
  const auto date = [precision](const IsoTime& time) {
    return std::tuple(time.year, precision >= TimePrecision::month ? time.month : 1,
                      precision >= TimePrecision::day ? time.day : 1);
  };
  return date(a) <=> date(b);
}

std::string date_text(const IsoTime& time, TimePrecision precision) {
  std::string text;
  append_digits(text, time.year, 4);
  for (const auto& [part, finest] :
       {std::pair(time.month, TimePrecision::month), std::pair(time.day, TimePrecision::day)}) {
    if (precision < finest) break;
    text += '-';
    append_digits(text, part, 2);
  }
  return text;
}

std::string iso_text(const IsoTime& time) {
  std::string text = date_text(time, time.precision);
  if (time.precision != TimePrecision::instant) return text;
  const auto append = [&](char before, int number) {
    text += before;
    append_digits(text, number, 2);
  };
  append('T', time.hour);
  append(':', time.minute);
  if (time.second != 0 || time.nanosecond != 0) append(':', time.second);
  if (time.nanosecond != 0) {
    text += '.';
    append_digits(text, time.nanosecond, 9);
    text.erase(text.find_last_not_of('0') + 1);
  }
  if (!time.ahead_of_utc) return text;
  const int ahead = *time.ahead_of_utc;
  if (ahead == 0) return text + 'Z';
  append(ahead < 0 ? '-' : '+', std::abs(ahead) / 60);
  append(':', std::abs(ahead) % 60);
  return text;
}

}  // namespace thiessen

#include "readings/times/time_format.h"

// Names of months do not change with the locale of the machine.
#define ONLY_C_LOCALE 1
#include <date/date.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <locale>
#include <sstream>
#include <utility>

#include "base/calendar_days.h"
#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

/// Whether the format has one of these conversions, such as %H or %OH.
bool has_any(std::string_view format, std::string_view conversions) {
  for (std::size_t at = 0; at + 1 < format.size(); ++at) {
    if (format[at] != '%') continue;
    ++at;
    while (at + 1 < format.size() &&
           std::string_view("EO0123456789").find(format[at]) != std::string_view::npos)
      ++at;
    if (conversions.find(format[at]) != std::string_view::npos) return true;
  }
  return false;
}

constexpr std::string_view years = "YyGgDFcx";
constexpr std::string_view months = "mbBhDFcx";
constexpr std::string_view days = "deDFcx";
constexpr std::string_view days_of_year = "j";
constexpr std::string_view clocks = "HIMSTRrXc";

/// A time in its parts, if there is such a time.
ParsedTime checked(IsoTime time) {
  const date::year_month_day day{date::year(time.year),
                                 date::month(static_cast<unsigned>(time.month)),
                                 date::day(static_cast<unsigned>(time.day))};
  const bool ends_day =
      time.hour == 24 && time.minute == 0 && time.second == 0 && time.nanosecond == 0;
  const bool there_is = day.ok() && time.year >= 1000 && time.year <= 9999 &&
                        (time.hour < 24 || ends_day) && time.minute < 60 && time.second < 60 &&
                        std::abs(time.ahead_of_utc.value_or(0)) < 24 * 60;
  return {time, there_is ? IsoTimeFault::none : IsoTimeFault::value};
}

int day_of_year(const IsoTime& time) {
  const date::year year(time.year);
  const date::year_month_day day{year, date::month(static_cast<unsigned>(time.month)),
                                 date::day(static_cast<unsigned>(time.day))};
  return (date::sys_days(day) - date::sys_days(year / 1 / 1)).count() + 1;
}

}  // namespace

struct TimeFormat::Stream {
  std::istringstream stream;
};

TimeFormat::TimeFormat(std::string format)
    : format_(std::move(format)), whole_format_(format_), stream_(std::make_unique<Stream>()) {
  stream_->stream.imbue(std::locale::classic());
  const std::size_t day_of_year = format_.find("%j");
  has_day_of_year_ = day_of_year != std::string::npos;
  if (has_day_of_year_) before_day_of_year_ = format_.substr(0, day_of_year);
  const bool has_day = has_any(format_, days) || has_any(format_, days_of_year);
  const bool has_month = has_day || has_any(format_, months);
  if (has_any(format_, clocks)) {
    precision_ = TimePrecision::instant;
  } else if (has_day) {
    precision_ = TimePrecision::day;
  } else if (has_month) {
    precision_ = TimePrecision::month;
  }
  if (!has_month) {
    whole_format_ += " %m";
    rest_ += " 1";
  }
  if (!has_day) {
    whole_format_ += " %d";
    rest_ += " 1";
  }
}

TimeFormat::~TimeFormat() = default;
TimeFormat::TimeFormat(TimeFormat&&) noexcept = default;
TimeFormat& TimeFormat::operator=(TimeFormat&&) noexcept = default;

bool TimeFormat::is_sound(const std::string& format) {
  if (format == excel) return true;
  if (!has_any(format, years)) return false;
  const bool has_day_of_year = has_any(format, days_of_year);
  const bool has_day = has_any(format, days);
  if (has_day && !has_any(format, months)) return false;
  return has_day || has_day_of_year || !has_any(format, clocks);
}

ParsedTime TimeFormat::read(std::string_view text) const {
  if (is_excel()) return read_serial(text);
  std::istringstream& stream = stream_->stream;
  const std::string whole = std::string(text) + rest_;
  stream.clear();
  stream.str(whole);
  date::fields<std::chrono::nanoseconds> fields;
  std::string zone;
  constexpr std::chrono::minutes no_offset{100'000};
  std::chrono::minutes offset = no_offset;
  date::from_stream(stream, whole_format_.c_str(), fields, &zone, &offset);
  if (stream.fail() || stream.peek() != std::char_traits<char>::eof()) return {};
  IsoTime time;
  time.precision = precision_;
  time.year = static_cast<int>(fields.ymd.year());
  time.month = static_cast<int>(static_cast<unsigned>(fields.ymd.month()));
  time.day = static_cast<int>(static_cast<unsigned>(fields.ymd.day()));
  if (fields.has_tod) {
    const auto clock = fields.tod.to_duration();
    if (clock < clock.zero() || clock > std::chrono::hours(24)) return {time, IsoTimeFault::value};
    const std::int64_t seconds = std::chrono::duration_cast<std::chrono::seconds>(clock).count();
    time.hour = static_cast<int>(seconds / 3600);
    time.minute = static_cast<int>(seconds / 60 % 60);
    time.second = static_cast<int>(seconds % 60);
    time.nanosecond = static_cast<int>((clock % std::chrono::seconds(1)).count());
  }
  if (offset != no_offset && has_any(format_, "z")) {
    time.ahead_of_utc = static_cast<int>(offset.count());
  } else if (zone == "UTC" || zone == "GMT" || zone == "Z") {
    time.ahead_of_utc = 0;
  }
  if (has_day_of_year_ && day_of_year_in(whole) != day_of_year(time))
    return {time, IsoTimeFault::value};
  return checked(time);
}

/// The number that stands where the format has the day of the year: a day that the year lacks
/// comes out as one of the next.
int TimeFormat::day_of_year_in(const std::string& text) const {
  std::istringstream& stream = stream_->stream;
  stream.clear();
  stream.str(text);
  date::fields<std::chrono::nanoseconds> fields;
  if (!before_day_of_year_.empty()) date::from_stream(stream, before_day_of_year_.c_str(), fields);
  stream.clear();  // a year alone is no date
  const auto at = static_cast<std::size_t>(std::max<std::streamoff>(stream.tellg(), 0));
  int day = 0;
  const char* const end = text.data() + std::min(at + 3, text.size());
  std::from_chars(text.data() + std::min(at, text.size()), end, day);
  return day;
}

ParsedTime TimeFormat::read_serial(std::string_view text) const {
  const Parsed<double> number = parse_number(text);
  if (!number) return {};
  constexpr double first = 61;        // 1 March 1900, before which serials are a day off
  constexpr double last = 2'958'465;  // 31 December 9999
  if (!(number.value >= first && number.value < last + 1)) return {{}, IsoTimeFault::value};
  constexpr std::int64_t epoch = 25'569;  // 1 January 1970
  const auto seconds = static_cast<std::int64_t>(std::llround(
      (number.value - static_cast<double>(epoch)) * static_cast<double>(seconds_of_day)));
  const std::string day = time_text(seconds, TimePrecision::instant);
  ParsedTime parsed = parse_iso_time(day);
  if (number.value == std::floor(number.value)) parsed.time.precision = TimePrecision::day;
  return parsed;
}

}  // namespace thiessen

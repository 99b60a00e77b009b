#include "gdal/layers/cell_form.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/calendar_days.h"
#include "base/iso_time.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

constexpr std::int64_t milliseconds_a_day = 86'400'000;

/// The letters of a code that stand for parts of a time: what is quoted, escaped or a colour or a
/// locale in brackets does not count, and of several sections the first alone.
std::string letters_of(std::string_view code) {
  std::string letters;
  for (std::size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (c == ';') break;
    if (c == '\\' || c == '_' || c == '*') {
      ++i;
    } else if (c == '"') {
      i = std::min(code.find('"', i + 1), code.size());
    } else if (c == '[') {
      const std::size_t end = std::min(code.find(']', i), code.size());
      const std::string inner = lower_case(std::string(code.substr(i + 1, end - i - 1)));
      // [hh]:mm counts on over a day.
      if (inner.find_first_not_of("hms") == std::string::npos) letters += inner;
      i = end;
    } else {
      letters += c;
    }
  }
  return lower_case(letters);
}

std::string two_digits(std::int64_t number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/// A fraction of a second: `.250`; empty where there is none.
std::string fraction(std::int64_t milliseconds) {
  if (milliseconds == 0) return {};
  const std::string digits = std::to_string(1000 + milliseconds);
  return "." + digits.substr(1);
}

/// The clock of so many milliseconds after midnight, with seconds where there are any.
std::string clock_text(std::int64_t milliseconds) {
  const std::int64_t seconds = milliseconds / 1000;
  std::string text = two_digits(seconds / 3600) + ":" + two_digits(seconds / 60 % 60);
  if (milliseconds % 60'000 != 0)
    text += ":" + two_digits(seconds % 60) + fraction(milliseconds % 1000);
  return text;
}

}  // namespace

CellForm built_in_form(int number) {
  const auto among = [&](int first, int last) { return first <= number && number <= last; };
  if (number == 22) return {true, true};
  if (among(18, 21) || among(32, 33) || among(45, 47)) return {false, true};
  return {among(14, 17) || among(27, 31) || among(34, 36) || among(50, 58), false};
}

CellForm form_of_code(std::string_view code) {
  std::string letters = letters_of(code);
  if (letters.starts_with("general")) return {};
  const std::size_t half = std::min(letters.find("am/pm"), letters.find("a/p"));
  const bool has_half = half != std::string::npos;
  if (has_half) letters.erase(half, letters[half + 1] == 'm' ? 5 : 3);
  const auto has = [&](const char* any) { return letters.find_first_of(any) != std::string::npos; };
  CellForm form;
  form.has_clock = has("hs") || has_half;
  form.has_date = has("yd") || (has("m") && !form.has_clock);
  return form;
}

bool has_clock(double serial) {
  return std::llround(serial * milliseconds_a_day) % milliseconds_a_day != 0;
}

std::optional<std::string> time_of_serial(double serial, CellForm form, bool with_clock,
                                          bool from_1904) {
  constexpr double march_1900 = 61;
  constexpr double year_10000 = 2'958'466;
  constexpr std::int64_t days_to_1970 = 25'569;
  constexpr std::int64_t days_to_1904 = 1'462;
  if (!form.has_date && serial >= 0 && serial < 2) {
    const std::int64_t of_clock = std::llround(serial * milliseconds_a_day);
    if (of_clock <= milliseconds_a_day) return clock_text(of_clock);
  }
  const double days = from_1904 ? serial + days_to_1904 : serial;
  if (!(days >= march_1900 && days < year_10000)) return std::nullopt;
  const std::int64_t milliseconds = std::llround(days * milliseconds_a_day);
  const std::int64_t of_day = milliseconds % milliseconds_a_day;
  const std::int64_t day = milliseconds / milliseconds_a_day - days_to_1970;
  std::string text = time_text(day * seconds_of_day, TimePrecision::day);
  if (with_clock || of_day != 0) text += "T" + clock_text(of_day);
  return text;
}

}  // namespace thiessen

#include "readings/times/time_shape.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/utf8.h"
#include "readings/times/time_format.h"

namespace thiessen {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// What is left of a text.
class Rest {
 public:
  explicit Rest(std::string_view text) : text_(text) {}

  bool empty() const { return text_.empty(); }
  char front() const { return text_.empty() ? '\0' : text_[0]; }
  std::size_t digits() const {
    return static_cast<std::size_t>(std::ranges::find_if_not(text_, is_digit) - text_.begin());
  }
  std::string_view letters() const {
    return text_.substr(
        0, static_cast<std::size_t>(std::ranges::find_if_not(text_, is_letter) - text_.begin()));
  }
  std::string_view take(std::size_t count) {
    const std::string_view taken = text_.substr(0, count);
    text_.remove_prefix(taken.size());
    return taken;
  }
  bool take(std::string_view text) {
    if (!text_.starts_with(text)) return false;
    text_.remove_prefix(text.size());
    return true;
  }
  void take_blanks() {
    while (front() == ' ') text_.remove_prefix(1);
  }

 private:
  std::string_view text_;
};

bool is_month_name(std::string_view name) {
  return month_called(name).has_value();
}

/// A date as far as its shape tells.
using Date = std::optional<TimeShape>;

/// 20101231, 2010123109, 201012310930, 20101231093000.
Date joined_digits(Rest& rest, std::size_t digits) {
  const std::string_view text = rest.take(digits);
  if (text < "1800" || text > "2200") return std::nullopt;
  std::string format = "%Y%m%d";
  if (digits >= 10) format += "%H";
  if (digits >= 12) format += "%M";
  if (digits >= 14) format += "%S";
  return TimeShape{format, ""};
}

/// 2010 Jan, 2010-January, 2010-Jan-5, behind the year and what parts it from the month.
Date month_name_second(Rest& rest, const std::string& mark) {
  const std::string_view name = rest.letters();
  if (!is_month_name(name)) return std::nullopt;
  rest.take(name.size());
  const std::string month = "%Y" + mark + "%b";
  if (rest.empty()) return TimeShape{month, ""};
  if (!rest.take(mark) || rest.digits() < 1 || rest.digits() > 2) return std::nullopt;
  rest.take(rest.digits());
  return TimeShape{month + mark + "%d", ""};
}

/// 2010/12/31, 2010.12.31, 2010-1-5, 2010/12, 2010-365 and dates with the name of a month.
Date year_first(Rest& rest) {
  rest.take(4);
  const std::string mark(rest.take(1));
  if (std::string_view("/.- ").find(mark) == std::string_view::npos) return std::nullopt;
  if (is_letter(rest.front())) return month_name_second(rest, mark);
  if (rest.digits() == 3 && mark != ".") {
    rest.take(3);
    return TimeShape{"%Y" + mark + "%j", ""};
  }
  if (rest.digits() < 1 || rest.digits() > 2) return std::nullopt;
  rest.take(rest.digits());
  if (rest.empty())
    return mark == "/" || mark == "." ? Date({"%Y" + mark + "%m", ""}) : std::nullopt;
  if (!rest.take(mark) || rest.digits() < 1 || rest.digits() > 2) return std::nullopt;
  rest.take(rest.digits());
  return TimeShape{"%Y" + mark + "%m" + mark + "%d", ""};
}

/// 31-Dec-2010, 31 December 2010, 01JAN2000, behind its day and what parts it from the month.
Date named_month(Rest& rest, const std::string& mark) {
  const std::string_view name = rest.letters();
  if (!is_month_name(name)) return std::nullopt;
  rest.take(name.size());
  if (!rest.take(mark) || rest.digits() != 4) return std::nullopt;
  rest.take(4);
  return TimeShape{"%d" + mark + "%b" + mark + "%Y", ""};
}

/// 31/12/2010, 12/31/2010, 12/2010 and dates with the name of a month.
Date year_last(Rest& rest) {
  rest.take(rest.digits());
  if (is_letter(rest.front())) return named_month(rest, "");
  const std::string mark(rest.take(1));
  if (std::string_view("/.- ").find(mark) == std::string_view::npos) return std::nullopt;
  if (is_letter(rest.front())) return named_month(rest, mark);
  if (rest.digits() == 4 && (mark == "/" || mark == "-")) {
    rest.take(4);
    return TimeShape{"%m" + mark + "%Y", ""};
  }
  if (rest.digits() < 1 || rest.digits() > 2) return std::nullopt;
  rest.take(rest.digits());
  if (!rest.take(mark) || rest.digits() != 4) return std::nullopt;
  rest.take(4);
  return TimeShape{"%d" + mark + "%m" + mark + "%Y", "%m" + mark + "%d" + mark + "%Y"};
}

/// Dec 31, 2010 and December 31 2010; Dec 2010, Dec-2010, DEC2010.
Date month_name_first(Rest& rest) {
  const std::string_view name = rest.letters();
  if (!is_month_name(name)) return std::nullopt;
  rest.take(name.size());
  for (const char* mark : {"", ", ", " ", "-", "/", "."}) {
    Rest behind = rest;
    if (!behind.take(mark) || behind.digits() != 4) continue;
    behind.take(4);
    if (!behind.empty()) continue;
    rest = behind;
    return TimeShape{std::string("%b") + mark + "%Y", ""};
  }
  if (!rest.take(" ") || rest.digits() < 1 || rest.digits() > 2) return std::nullopt;
  rest.take(rest.digits());
  const std::string comma = rest.take(",") ? "," : "";
  if (!rest.take(" ") || rest.digits() != 4) return std::nullopt;
  rest.take(4);
  return TimeShape{"%b %d" + comma + " %Y", ""};
}

Date date_shape(Rest& rest) {
  const std::size_t digits = rest.digits();
  if (digits == 0) return month_name_first(rest);
  if (digits == 4) return year_first(rest);
  if (digits <= 2) return year_last(rest);
  const bool joined = digits == 8 || digits == 10 || digits == 12 || digits == 14;
  return joined ? joined_digits(rest, digits) : std::nullopt;
}

/// What parts the clock from the date, as a format has it; nothing where nothing known does.
std::optional<std::string> part(Rest& rest) {
  for (const char* mark : {"T", ", ", ":", " "}) {
    if (!rest.take(mark)) continue;
    rest.take_blanks();
    return mark;
  }
  return std::nullopt;
}

/// 06:00, 6:00:00, 6:00:00.5, 0600, 060000, 6: its format; nothing where it is none.
std::optional<std::string> clock_shape(Rest& rest) {
  const std::size_t digits = rest.digits();
  rest.take(digits);
  if (digits == 4) return "%H%M";
  if (digits == 6) return "%H%M%S";
  if (digits != 1 && digits != 2) return std::nullopt;
  if (!rest.take(":")) return "%H";
  if (rest.digits() != 2) return std::nullopt;
  rest.take(2);
  if (!rest.take(":")) return "%H:%M";
  if (rest.digits() != 2) return std::nullopt;
  rest.take(2);
  if (rest.take(".")) rest.take(rest.digits());
  return "%H:%M:%S";
}

/// AM or PM behind a clock makes it one of twelve hours.
bool take_half_of_day(Rest& rest, std::string& format) {
  rest.take_blanks();
  const std::string_view letters = rest.letters();
  if (!equal_ignoring_case(letters, "AM") && !equal_ignoring_case(letters, "PM")) return false;
  rest.take(letters.size());
  format[format.find("%H") + 1] = 'I';
  format += " %p";
  return true;
}

/// The format of a zone at the end; nothing where the end is none.
std::optional<std::string> zone_shape(Rest& rest) {
  rest.take_blanks();
  if (rest.empty()) return "";
  const std::string_view name = rest.letters();
  if (name == "UTC" || name == "GMT" || name == "Z") {
    rest.take(name.size());
    return rest.empty() ? std::optional<std::string>(" %Z") : std::nullopt;
  }
  if (!rest.take("+") && !rest.take("-")) return std::nullopt;
  const std::size_t digits = rest.digits();
  rest.take(digits);
  if (rest.empty())
    return digits == 4 || digits == 2 ? std::optional<std::string>(" %z") : std::nullopt;
  if (digits != 2 || !rest.take(":") || rest.digits() != 2) return std::nullopt;
  rest.take(2);
  return rest.empty() ? std::optional<std::string>(" %Ez") : std::nullopt;
}

bool shows_clock(const std::string& format) {
  return format.find("%H") != std::string::npos || format.find("%I") != std::string::npos;
}

/// The format of what stands behind a date, which may be nothing; nothing where it is no clock.
std::optional<std::string> behind_date(Rest& rest) {
  if (rest.empty()) return "";
  const std::optional<std::string> mark = part(rest);
  if (!mark) return std::nullopt;
  std::optional<std::string> clock = clock_shape(rest);
  if (!clock) return std::nullopt;
  take_half_of_day(rest, *clock);
  const std::optional<std::string> zone = zone_shape(rest);
  if (!zone) return std::nullopt;
  return *mark + *clock + *zone;
}

/// The dates that three numbers of one or two digits may be, or two with the name of a month
/// between them, or a month's and a year.
std::vector<std::string> short_dates(Rest& rest) {
  const auto is_short = [&] { return rest.digits() == 1 || rest.digits() == 2; };
  if (is_letter(rest.front())) {  // Jan-99
    const std::string_view name = rest.letters();
    rest.take(name.size());
    const std::string mark(is_digit(rest.front()) ? "" : rest.take(1));
    if (!is_month_name(name) || rest.digits() != 2) return {};
    rest.take(2);
    return {"%b" + mark + "%y"};
  }
  if (!is_short()) return {};
  rest.take(rest.digits());
  const bool is_parted = !is_letter(rest.front());
  const std::string mark(is_parted ? rest.take(1) : "");
  if (is_parted && (mark.empty() || std::string_view("/.- ").find(mark) == std::string_view::npos))
    return {};
  const bool is_named = is_letter(rest.front());
  const std::string_view name = rest.letters();
  if (is_named ? !is_month_name(name) : !is_short()) return {};
  rest.take(is_named ? name.size() : rest.digits());
  if (!rest.take(mark) || !is_short()) return {};
  rest.take(rest.digits());
  if (is_named) return {"%d" + mark + "%b" + mark + "%y", "%y" + mark + "%b" + mark + "%d"};
  return {"%d" + mark + "%m" + mark + "%y", "%m" + mark + "%d" + mark + "%y",
          "%y" + mark + "%m" + mark + "%d"};
}

/// Whether a text may be the number of a day in a spreadsheet, in the years from 1927 to 2100.
bool is_serial(std::string_view text) {
  Rest rest(text);
  if (rest.digits() != 5 || text > "73415") return false;
  rest.take(5);
  if (rest.take(".")) rest.take(rest.digits());
  return rest.empty();
}

}  // namespace

std::optional<int> month_called(std::string_view name) {
  constexpr std::array<std::string_view, 12> names = {
      "january", "february", "march",     "april",   "may",      "june",
      "july",    "august",   "september", "october", "november", "december"};
  const auto found = std::ranges::find_if(names, [&](std::string_view month) {
    return equal_ignoring_case(name, month) || equal_ignoring_case(name, month.substr(0, 3));
  });
  if (found == names.end()) return std::nullopt;
  return static_cast<int>(found - names.begin()) + 1;
}

TimeShape time_shape(std::string_view text) {
  Rest rest(trimmed(text));
  Date date = date_shape(rest);
  if (!date) return {};
  const std::optional<std::string> clock = behind_date(rest);
  if (!clock) return {};
  date->format += *clock;
  if (!date->month_first.empty()) date->month_first += *clock;
  return *date;
}

std::vector<std::string> open_formats(std::string_view text) {
  text = trimmed(text);
  if (is_serial(text)) return {std::string(TimeFormat::excel)};
  std::vector<std::string> formats;
  if (text.size() == 7 && Rest(text).digits() == 7) {
    if (text >= "1800" && text < "2200") formats.emplace_back("%Y%j");
  } else if (text.size() == 6 && Rest(text).digits() == 6) {
    if (text >= "1800" && text < "2200") formats.emplace_back("%Y%m");
    formats.insert(formats.end(), {"%y%m%d", "%d%m%y"});
  } else {
    Rest rest(text);
    formats = short_dates(rest);
    const std::optional<std::string> clock = behind_date(rest);
    if (!clock) return {};
    for (std::string& format : formats) format += *clock;
  }
  std::erase_if(formats, [&](const std::string& format) { return !TimeFormat(format).read(text); });
  return formats;
}

bool is_date(std::string_view text) {
  const std::string format = time_shape(text).format;
  return format.find("%d") != std::string::npos && !shows_clock(format);
}

bool is_date_with_clock(std::string_view text) {
  return shows_clock(time_shape(text).format);
}

bool is_clock(std::string_view text) {
  const std::string whole = "2000-01-01 " + std::string(trimmed(text));
  const std::string format = time_shape(whole).format;
  return shows_clock(format) && TimeFormat(format).read(whole);
}

}  // namespace thiessen

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/iso_time.h"
#include "base/number.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/message_laws.h"
#include "rainfall/series/dated_readings.h"
#include "rainfall/series/step_intervals.h"
#include "rainfall/series/step_length.h"
#include "readings/readings_grammar.h"
#include "readings/readings_order.h"
#include "readings/times/time_reader.h"

namespace thiessen::fuzzers {
namespace {

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Takes so many digits from the front, and tells how many there were.
std::size_t take_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(count);
  return count;
}

bool take_one_of(std::string_view& text, std::string_view characters) {
  if (text.empty() || characters.find(text[0]) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// The grammar of number.h, told once more.
bool is_number(std::string_view text, char mark) {
  take_one_of(text, "+-");
  std::size_t digits = take_digits(text);
  if (take_one_of(text, {&mark, 1})) digits += take_digits(text);
  if (digits == 0) return false;
  if (!take_one_of(text, "eE")) return text.empty();
  take_one_of(text, "+-");
  return take_digits(text) > 0 && text.empty();
}

/// Requires that a number is read as the C library reads it, whether it is padded or not.
void read_number(std::string_view text, DecimalMark mark) {
  const std::string padded = std::string(text) + "12345678";
  const Parsed<double> number = parse_number(text, mark);
  const Parsed<double> again =
      parse_padded_number(std::string_view(padded).substr(0, text.size()), mark);
  require(number.fault == again.fault && same_bits(number.value, again.value),
          "another number with padding");
  const bool is_one = is_number(text, static_cast<char>(mark));
  require(is_one == (number.fault != NumberFault::not_a_number), "another grammar of numbers");
  if (!is_one) return;
  std::string pointed(text);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  const double expected = std::strtod(pointed.c_str(), nullptr);
  const std::string_view mantissa =
      std::string_view(pointed).substr(0, pointed.find_first_of("eE"));
  const bool is_zero = mantissa.find_first_of("123456789") == std::string_view::npos;
  const bool in_range = std::isfinite(expected) && (is_zero || expected != 0);
  require(in_range == static_cast<bool>(number), "another range of numbers");
  require(!number || same_bits(number.value, expected), "another number than the C library's");
}

/// Requires that a number that is printed is read back as the same, and rounded as it says.
void print_number(double value, int decimals) {
  if (!std::isfinite(value)) return;
  const std::string text = shortest_text(value);
  const auto again = parse_number(text);
  require(again && again.value == value, "a number that does not read back: " + text);
  require(value != 0 || text == "0", "a zero with a sign");
  const std::string fixed = fixed_text(value, decimals);
  const auto rounded = parse_number(fixed);
  require(rounded && fixed_text(rounded.value, decimals) == fixed, "not rounded: " + fixed);
  std::array<char, 512> expected;
  std::snprintf(expected.data(), expected.size(), "%.*f", decimals, value);
  const std::string_view plain(expected.data());
  const bool minus_zero = plain.find_first_not_of("-0.") == std::string_view::npos;
  require(fixed == plain.substr(minus_zero && plain.starts_with('-') ? 1 : 0),
          "rounded otherwise than by the C library: " + fixed);
}

std::string two_digits(int number) {
  return (number < 10 ? "0" : "") + std::to_string(number);
}

/// A time in all that ISO 8601 wants, or in its basic form.
std::string text_of(const IsoTime& time, bool extended) {
  const std::string hyphen = extended ? "-" : "";
  const std::string colon = extended ? ":" : "";
  const std::string year = std::to_string(time.year);
  std::string text = std::string(4 - year.size(), '0') + year;
  if (time.precision >= TimePrecision::month) text += hyphen + two_digits(time.month);
  if (time.precision >= TimePrecision::day) text += hyphen + two_digits(time.day);
  if (time.precision < TimePrecision::instant) return text;
  const std::string nanosecond = std::to_string(time.nanosecond);
  text += "T" + two_digits(time.hour) + colon + two_digits(time.minute) + colon +
          two_digits(time.second) + "." + std::string(9 - nanosecond.size(), '0') + nanosecond;
  if (!time.ahead_of_utc) return text;
  const int ahead = *time.ahead_of_utc;
  return text + (ahead < 0 ? "-" : "+") + two_digits(std::abs(ahead) / 60) + colon +
         two_digits(std::abs(ahead) % 60);
}

bool same_time(const IsoTime& a, const IsoTime& b) {
  return a.precision == b.precision && a.year == b.year && a.month == b.month && a.day == b.day &&
         a.hour == b.hour && a.minute == b.minute && a.second == b.second &&
         a.nanosecond == b.nanosecond && a.ahead_of_utc == b.ahead_of_utc;
}

/// Requires that a moment that is printed is read as that moment, or has a year that ISO 8601 does
/// not write: one beyond 0000 to 9999, by the zone's offset or the end of a day.
void print_moment(const IsoTime& time) {
  constexpr std::int64_t year_0 = -62'167'219'200;
  constexpr std::int64_t year_10000 = 253'402'300'800;
  const std::int64_t seconds = moment_seconds(time);
  require(clock_seconds(time) - seconds == std::int64_t{60} * time.ahead_of_utc.value_or(0),
          "a moment by another zone");
  const std::string text = time_text(seconds, TimePrecision::instant);
  if (seconds < year_0) return require(text.starts_with("-0001-12-31T"), "another year: " + text);
  if (seconds >= year_10000)
    return require(text.starts_with("10000-01-0"), "another year: " + text);
  const ParsedTime again = parse_iso_time(text);
  require(again && clock_seconds(again.time) == seconds, "another moment once printed: " + text);
}

/// Requires that a time that is read is the same once it is printed and read again.
void read_time(std::string_view text) {
  const ParsedTime parsed = parse_iso_time(text);
  if (!parsed) {
    try {
      time_of_step(text, TimePrecision::year, "r.csv", 1);
    } catch (const Error& error) {
      return require_placed(error, "r.csv", 1);
    }
    // Blanks round it are the one thing that a step's time may have besides.
    return require(trimmed(text) != text && parse_iso_time(trimmed(text)), "a step without a time");
  }
  const IsoTime& time = parsed.time;
  for (const bool extended : {true, false}) {
    if (!extended && time.precision == TimePrecision::month) continue;
    const ParsedTime again = parse_iso_time(text_of(time, extended));
    require(again && same_time(again.time, time), "another time once printed and read again");
    require(order_of_moments(again.time, time) == 0, "a time that is not at its moment");
  }
  for (const TimePrecision precision :
       {TimePrecision::year, TimePrecision::month, TimePrecision::day}) {
    const ParsedTime date = parse_iso_time(date_text(time, precision));
    require(date && date.time.precision == precision, "another precision of a date");
    require(order_of_dates(date.time, time, precision) == 0, "another date once printed");
  }
  print_moment(time);
}

/// Requires that steps that follow each other at multiples of one length lack what is between them.
void lack_steps(const std::vector<std::string>& times) {
  StepIntervals intervals;
  std::vector<std::int64_t> moments;
  for (const std::string& text : times) {
    const ParsedTime parsed = parse_iso_time(text);
    intervals.note(parsed);
    if (parsed) moments.push_back(moment_seconds(parsed.time));
  }
  require(intervals.has_labels() == (moments.size() < times.size()), "other labels");
  const std::optional<StepLength> step = intervals.step();
  if (!step) return;
  const auto lacking = intervals.lacking(*step);
  const bool ascend = std::is_sorted(moments.begin(), moments.end());
  const bool descend = std::is_sorted(moments.rbegin(), moments.rend());
  require(lacking.has_value() == (ascend || descend), "lacking steps of times in no order");
  if (!lacking || step->months > 0) return;
  std::int64_t expected = 0;
  for (std::size_t i = 1; i < moments.size(); ++i) {
    const std::int64_t apart = std::abs(moments[i] - moments[i - 1]);
    expected += apart == 0 ? 0 : (apart - 1) / step->seconds;
  }
  require(lacking->steps == static_cast<std::size_t>(expected), "another count of lacking steps");
}

/// Requires that orders of times are orders, and that TimeOrder is not deceived.
void order_times(std::string_view text) {
  std::vector<std::string> times;
  for (Bytes bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
       !bytes.empty() && times.size() < 8;)
    times.emplace_back(bytes.until('\n'));
  TimeOrder order;
  std::set<std::string> seen;
  for (const std::string& time : times) {
    const bool differ = order.follows(time);
    require(seen.insert(time).second || !differ, "a time that comes twice, and no notice");
    require(differ == order.holds() && (!differ || order.is_last(time)), "another last time");
  }
  lack_steps(times);
  for (const std::string& a : times) {
    for (const std::string& b : times) {
      const int one = compare_with_numbers(a, b);
      const int other = compare_with_numbers(b, a);
      require((one < 0) == (other > 0) && (a != b || one == 0), "no order of times");
      const auto of_a = parse_iso_time(a);
      const auto of_b = parse_iso_time(b);
      if (!of_a || !of_b) continue;
      const auto moments = order_of_moments(of_a.time, of_b.time);
      require(0 <=> moments == order_of_moments(of_b.time, of_a.time), "no order of moments");
    }
  }
}

/// Requires that a field of rainfall is an amount, a gap or a fault, as its number says.
void read_field(Bytes& bytes) {
  const auto flags = bytes.next();
  const DecimalMark mark = flags % 2 == 0 ? DecimalMark::point : DecimalMark::comma;
  const std::vector<std::string> missing = {std::string(bytes.until('\n'))};
  const std::vector<std::string> trace = {std::string(bytes.until('\n'))};
  const ReadingGrammar grammar(missing, trace, mark);
  const std::string field(bytes.rest());
  const std::string padded = field + "12345678";
  const Reading reading = grammar.read(field, false);
  const Reading again = grammar.read(std::string_view(padded).substr(0, field.size()), true);
  require(reading.kind == again.kind && same_bits(reading.amount, again.amount),
          "another reading with padding");
  const bool is_amount = reading.kind == ReadingKind::amount;
  require(is_amount ? std::isfinite(reading.amount) && !std::signbit(reading.amount)
                    : std::isnan(reading.amount),
          "an amount that is none");
  require(grammar.read(missing[0], false).kind == ReadingKind::missing, "a gap that is none");
  const auto number = parse_number(trimmed(field), mark);
  if (is_amount && number)
    require(reading.amount == number.value || reading.amount == 0, "another amount");
  if (reading.kind == ReadingKind::negative) require(number && number.value < 0, "not negative");
  if (reading.kind == ReadingKind::not_a_number)
    require(number.fault == NumberFault::not_a_number, "a number that is said to be none");
}

/// Times that are not ISO 8601: what is read exists, can be written, and is the same once more.
void read_written_times(std::string_view text) {
  TimeReader reader;
  TimeReader once_more;
  std::size_t line = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const auto time = reader.read(one, ++line);
    const auto again = once_more.read(one, line);
    require(time.has_value() == again.has_value(), "another time once more");
    if (!time || !time->parsed) continue;
    const ParsedTime iso = parse_iso_time(iso_text(time->parsed.time));
    require(iso && order_of_moments(iso.time, time->parsed.time) == 0,
            "a time that does not read back");
    require(again->parsed && order_of_moments(again->parsed.time, iso.time) == 0, "another moment");
  }
}

}  // namespace

void fuzz_values(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  switch (bytes.below(9)) {
    case 0:
    case 1:
      read_number(bytes.rest(), DecimalMark::point);
      return read_number(bytes.rest(), DecimalMark::comma);
    case 2: {
      const auto decimals = static_cast<int>(bytes.below(101));
      double value = 0;
      const std::string_view rest = bytes.rest();
      std::memcpy(&value, rest.data(), std::min(rest.size(), sizeof value));
      return print_number(value, decimals);
    }
    case 3:
    case 4:
      return read_time(bytes.rest());
    case 5:
      return order_times(bytes.rest());
    case 8:
      return read_written_times(bytes.rest());
    default:
      return read_field(bytes);
  }
}

}  // namespace thiessen::fuzzers

#include "readings/units/rain_unit.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/utf8.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr RainUnit millimetre = {"mm", "", 1, 1};
constexpr RainUnit centimetre = {"cm", "", 10, 1};
constexpr RainUnit metre = {"m", "", 1000, 1};
constexpr RainUnit inch = {"in", "", 127, 5};
constexpr RainUnit foot = {"ft", "", 1524, 5};
constexpr RainUnit tenth_of_millimetre = {"0.1mm", "", 1, 10};
constexpr RainUnit hundredth_of_inch = {"0.01in", "", 127, 500};

struct Spelling {
  std::string_view text;  ///< in small letters, without blanks, _ and -
  RainUnit unit;
};

constexpr std::array<Spelling, 31> depths = {{{"mm", millimetre},
                                              {"millimeter", millimetre},
                                              {"millimetre", millimetre},
                                              {"millimeters", millimetre},
                                              {"millimetres", millimetre},
                                              {"l/m2", millimetre},
                                              {"lm2", millimetre},
                                              {"kg/m2", millimetre},
                                              {"kgm2", millimetre},
                                              {"cm", centimetre},
                                              {"m", metre},
                                              {"in", inch},
                                              {"inch", inch},
                                              {"inches", inch},
                                              {"ft", foot},
                                              {"0.1mm", tenth_of_millimetre},
                                              {"1/10mm", tenth_of_millimetre},
                                              {"mm/10", tenth_of_millimetre},
                                              {"tenthsofmm", tenth_of_millimetre},
                                              {"tenthmm", tenth_of_millimetre},
                                              {"tenthsmm", tenth_of_millimetre},
                                              {"tenthsofamm", tenth_of_millimetre},
                                              {"tenthsofamillimeter", tenth_of_millimetre},
                                              {"tenthsofamillimetre", tenth_of_millimetre},
                                              {"0.01in", hundredth_of_inch},
                                              {"1/100in", hundredth_of_inch},
                                              {"0.01inch", hundredth_of_inch},
                                              {"0.01inches", hundredth_of_inch},
                                              {"hundredthsofinch", hundredth_of_inch},
                                              {"hundredthsofaninch", hundredth_of_inch},
                                              {"hundredthsofin", hundredth_of_inch}}};

struct Rate {
  std::string_view name;
  StepLength time;
};

constexpr std::array<Rate, 15> rates = {{{"/s", {0, 1}},
                                         {"/min", {0, 60}},
                                         {"/5min", {0, 300}},
                                         {"/10min", {0, 600}},
                                         {"/15min", {0, 900}},
                                         {"/30min", {0, 1'800}},
                                         {"/h", {0, 3'600}},
                                         {"/2h", {0, 7'200}},
                                         {"/3h", {0, 10'800}},
                                         {"/6h", {0, 21'600}},
                                         {"/12h", {0, 43'200}},
                                         {"/day", {0, 86'400}},
                                         {"/week", {0, 604'800}},
                                         {"/month", {1, 0}},
                                         {"/year", {12, 0}}}};

struct TimeSpelling {
  std::string_view text;
  StepLength time;
};

constexpr std::array<TimeSpelling, 24> times = {
    {{"s", {0, 1}},         {"sec", {0, 1}},        {"second", {0, 1}},   {"seconds", {0, 1}},
     {"min", {0, 60}},      {"mins", {0, 60}},      {"minute", {0, 60}},  {"minutes", {0, 60}},
     {"h", {0, 3'600}},     {"hr", {0, 3'600}},     {"hrs", {0, 3'600}},  {"hour", {0, 3'600}},
     {"hours", {0, 3'600}}, {"d", {0, 86'400}},     {"day", {0, 86'400}}, {"days", {0, 86'400}},
     {"wk", {0, 604'800}},  {"week", {0, 604'800}}, {"mon", {1, 0}},      {"month", {1, 0}},
     {"months", {1, 0}},    {"yr", {12, 0}},        {"year", {12, 0}},    {"a", {12, 0}}}};

/// Takes a beginning off a text; whether it was there.
bool take_off(std::string_view& text, std::string_view beginning) {
  if (!text.starts_with(beginning)) return false;
  text.remove_prefix(beginning.size());
  return true;
}

/// The number that a text begins with, which is taken off; 1 where there is none, 0 where it is
/// longer than any rate's.
std::int64_t take_number_off(std::string_view& text) {
  constexpr std::size_t most_digits = 4;
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  if (digits == 0) return 1;
  std::int64_t number = 0;
  for (const char digit : text.substr(0, digits)) number = 10 * (number % 100'000) + (digit - '0');
  text.remove_prefix(digits);
  return digits > most_digits ? 0 : number;
}

/// How a rate is called whose time is written after its depth: /h, per hour, /15min, h-1 (without
/// its sign), h. Without a sign of division a bare time is known by its commonest names alone, for
/// mms and mmin are other words.
std::optional<std::string_view> rate_called(std::string_view text) {
  const bool is_parted = take_off(text, "/") || take_off(text, "per");
  const std::int64_t number = is_parted ? take_number_off(text) : 1;
  const bool is_inverse = !is_parted && text.ends_with('1');
  if (is_inverse) text.remove_suffix(1);
  const bool is_common = text == "h" || text == "hr" || text == "d" || text == "day";
  if (!is_parted && !is_inverse && !is_common) return std::nullopt;
  for (const TimeSpelling& spelling : times) {
    if (spelling.text != text) continue;
    const StepLength time{number * spelling.time.months, number * spelling.time.seconds};
    for (const Rate& rate : rates)
      if (rate.time == time) return rate.name;
  }
  return std::nullopt;
}

/// A text in small letters, without blanks and signs of joining; raised digits are plain ones.
std::string plain_letters(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    if (take_off(text, "\u00b2")) {
      plain += '2';
    } else if (take_off(text, "\u00b9")) {
      plain += '1';
    } else if (!take_off(text, "\u207b") && !take_off(text, "\u2212") &&
               !take_off(text, "\u00b7")) {
      const char c = text.front();
      text.remove_prefix(1);
      if (c == ' ' || c == '_' || c == '-') continue;
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return plain;
}

std::optional<RainUnit> depth_of(std::string_view plain) {
  for (const Spelling& spelling : depths) {
    if (spelling.text == plain) return spelling.unit;
  }
  return std::nullopt;
}

/// Whether a unit means rain whatever stands before it: a metre or a foot could be anything's.
bool is_of_rain_alone(const RainUnit& unit) {
  return unit.depth != metre.depth && unit.depth != foot.depth;
}

/// Takes off what surrounds the words of a line: marks of remarks, quotes, empty fields.
std::string_view bare(std::string_view text) {
  constexpr std::string_view marks = "#;,!%*\"' \t|.";
  const std::size_t begin = text.find_first_not_of(marks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(marks) + 1 - begin);
}

/// A unit that is rain's wherever it stands, alone or with its sign behind it: inches (in).
std::optional<RainUnit> unit_alone(std::string_view text) {
  text = bare(text);
  if ((text.ends_with(')') || text.ends_with(']')) && text.find_first_of("([") > 0)
    text = trimmed(text.substr(0, text.find_first_of("([")));
  const auto unit = rain_unit(text);
  return unit && is_of_rain_alone(*unit) ? unit : std::nullopt;
}

}  // namespace

bool speaks_of_rain(std::string_view text) {
  const std::string plain = plain_letters(text);
  constexpr std::array<std::string_view, 13> words = {
      "rain",  "precip", "prcp", "nieders", "regen",  "lluvia",      "chuva",
      "pluie", "pluvio", "pcp",  "ppt",     "\u96e8", "\u964d\u6c34"};
  return std::ranges::any_of(
      words, [&](std::string_view word) { return plain.find(word) != std::string::npos; });
}

std::optional<RainUnit> unit_in_line(std::string_view line) {
  line = bare(line);
  if (const std::size_t parting = line.find_first_of(":=,;\t"); parting != std::string_view::npos) {
    const std::string_view label = bare(line.substr(0, parting));
    const bool is_label = std::ranges::any_of(
        known::unit_labels, [&](std::string_view name) { return same_name(label, name); });
    if (is_label) return unit_alone(line.substr(parting + 1));
  }
  if (!speaks_of_rain(line)) return std::nullopt;
  if (line.ends_with(')') || line.ends_with(']')) {
    const auto unit = unit_in_suffix(line.substr(std::min(line.find_last_of("(["), line.size())));
    return unit && is_of_rain_alone(*unit) ? unit : std::nullopt;
  }
  constexpr std::string_view in = " in ";
  if (const std::size_t at = line.rfind(in); at != std::string_view::npos)
    return unit_alone(line.substr(at + in.size()));
  const std::size_t comma = line.rfind(',');
  return comma == std::string_view::npos ? std::nullopt : unit_alone(line.substr(comma + 1));
}

std::optional<RainUnit> rain_unit(std::string_view text) {
  const std::string plain = plain_letters(text);
  if (const auto depth = depth_of(plain)) return depth;
  for (const Spelling& spelling : depths) {
    std::string_view rest = plain;
    if (!take_off(rest, spelling.text)) continue;
    const auto rate = rate_called(rest);
    if (!rate) continue;
    RainUnit unit = spelling.unit;
    unit.rate = *rate;
    return unit;
  }
  return std::nullopt;
}

std::optional<StepLength> time_of_rate(const RainUnit& unit) {
  for (const Rate& rate : rates)
    if (rate.name == unit.rate) return rate.time;
  return std::nullopt;
}

std::string depth_unit(const std::string& unit) {
  const std::optional<RainUnit> known = rain_unit(unit);
  return known && time_of_rate(*known) ? std::string(known->depth) : unit;
}

std::optional<RainUnit> unit_in_suffix(std::string_view suffix) {
  constexpr std::string_view opening = "_-. ([";
  if (suffix.empty() || opening.find(suffix.front()) == std::string_view::npos) return std::nullopt;
  const std::size_t begin = suffix.find_first_not_of(opening);
  if (begin == std::string_view::npos) return std::nullopt;
  suffix.remove_prefix(begin);
  if (suffix.back() == ')' || suffix.back() == ']') suffix.remove_suffix(1);
  return rain_unit(suffix);
}

std::optional<RainUnit> unit_in_name(std::string_view column) {
  column = trimmed(column);
  if (column.ends_with(')') || column.ends_with(']')) {
    const std::size_t opening = column.find_last_of("([");
    if (opening == std::string_view::npos) return std::nullopt;
    return unit_in_suffix(column.substr(opening));
  }
  for (const std::string_view name : known::values) {
    if (column.size() <= name.size() || !same_name(column.substr(0, name.size()), name)) continue;
    if (const auto unit = unit_in_suffix(column.substr(name.size()))) return unit;
  }
  const std::size_t parting = column.find_last_of("_ ");
  if (parting == std::string_view::npos) return std::nullopt;
  const auto unit = unit_in_suffix(column.substr(parting));
  return unit && is_of_rain_alone(*unit) ? unit : std::nullopt;
}

RainFactor factor_between(const RainUnit& from, const RainUnit& to) {
  std::int64_t multiply = from.multiply * to.divide;
  std::int64_t divide = from.divide * to.multiply;
  const auto from_time = time_of_rate(from);
  const auto to_time = time_of_rate(to);
  if (from_time && to_time && from_time->seconds > 0 && to_time->seconds > 0) {
    multiply *= to_time->seconds;
    divide *= from_time->seconds;
  }
  const std::int64_t common = std::gcd(multiply, divide);
  const std::int64_t numerator = multiply / common;
  const std::int64_t denominator = divide / common;
  return {static_cast<double>(numerator), static_cast<double>(denominator)};
}

}  // namespace thiessen

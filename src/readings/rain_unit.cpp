#include "readings/rain_unit.h"

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

struct RateSpelling {
  std::string_view text;
  std::string_view rate;
};

/// How the time of a rate is written after the depth.
constexpr std::array<RateSpelling, 10> rates = {{{"/h", "/h"},
                                                 {"/hr", "/h"},
                                                 {"/hour", "/h"},
                                                 {"/d", "/day"},
                                                 {"/day", "/day"},
                                                 {"h", "/h"},
                                                 {"hr", "/h"},
                                                 {"d", "/day"},
                                                 {"day", "/day"},
                                                 {"perday", "/day"}}};

std::string plain_letters(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    if (c == ' ' || c == '_' || c == '-') continue;
    plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
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

}  // namespace

std::optional<RainUnit> rain_unit(std::string_view text) {
  const std::string plain = plain_letters(text);
  if (const auto depth = depth_of(plain)) return depth;
  for (const RateSpelling& spelling : rates) {
    if (!plain.ends_with(spelling.text)) continue;
    auto unit = depth_of(std::string_view(plain).substr(0, plain.size() - spelling.text.size()));
    if (!unit) continue;
    unit->rate = spelling.rate;
    return unit;
  }
  return std::nullopt;
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
  const std::int64_t multiply = from.multiply * to.divide;
  const std::int64_t divide = from.divide * to.multiply;
  const std::int64_t common = std::gcd(multiply, divide);
  const std::int64_t numerator = multiply / common;
  const std::int64_t denominator = divide / common;
  return {static_cast<double>(numerator), static_cast<double>(denominator)};
}

}  // namespace thiessen

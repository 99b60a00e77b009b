#include "base/number.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <limits>

namespace thiessen {
namespace {

/// The powers of ten that a double holds exactly.
constexpr std::array<double, 23> exact_tens = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                               1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                               1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t exact_integers = std::uint64_t{1} << 53;
constexpr int digits_that_fit = 18;  ///< any 18 digits fit 64 bits
/// The exponent is capped at this value, which is far beyond what any count of decimals could bring
/// back, and far below overflow.
constexpr std::int64_t exponent_ceiling = 1'000'000'000'000'000;

unsigned digit(char c) {
  return static_cast<unsigned>(c) - unsigned{'0'};
}

/// The parts of a number that the grammar finds: mantissa * 10^exponent, where they fit.
struct Decimal {
  std::uint64_t mantissa = 0;
  /// Digits in the mantissa from the first that is not 0. Beyond 18 the mantissa is not whole.
  int significant = 0;
  std::int64_t exponent = 0;
  bool negative = false;
};

class DecimalScanner {
 public:
  DecimalScanner(std::string_view text, DecimalMark mark)
      : at_(text.data()), end_(text.data() + text.size()), mark_(static_cast<char>(mark)) {}

  /// Reads the whole text into `decimal`. Returns whether it is a number.
  bool scan(Decimal& decimal) {
    decimal.negative = take('-');
    if (!decimal.negative) take('+');
    bool any = mantissa_digits(decimal);
    if (take(mark_)) {
      const char* const fraction = at_;
      any = mantissa_digits(decimal) || any;
      decimal.exponent = fraction - at_;
    }
    return any && (!(take('e') || take('E')) || exponent(decimal)) && at_ == end_;
  }

 private:
  bool take(char c) {
    if (at_ == end_ || *at_ != c) return false;
    ++at_;
    return true;
  }

  bool mantissa_digits(Decimal& decimal) {
    const char* const begin = at_;
    for (; at_ != end_ && digit(*at_) < 10; ++at_) {
      if (decimal.significant <= digits_that_fit) {
        decimal.mantissa = decimal.mantissa * 10 + digit(*at_);
        decimal.significant += decimal.mantissa != 0;
      }
    }
    return at_ != begin;
  }

  bool exponent(Decimal& decimal) {
    const bool negative = take('-');
    if (!negative) take('+');
    const char* const begin = at_;
    std::int64_t value = 0;
    for (; at_ != end_ && digit(*at_) < 10; ++at_) {
      if (value < exponent_ceiling) value = value * 10 + digit(*at_);
    }
    decimal.exponent += negative ? -value : value;
    return at_ != begin;
  }

  const char* at_;
  const char* end_;
  char mark_;
};

/// Reads a number that does not fit in a mantissa of 53 bits times an exact power of ten. Requires
/// that it is not zero.
Parsed<double> parse_long_number(std::string_view text) {
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const std::errc error = std::from_chars(text.data(), text.data() + text.size(), value).ec;
  if (error != std::errc() || !std::isfinite(value) || value == 0) {
    return {0, NumberFault::out_of_range};
  }
  return {value, NumberFault::none};
}

}  // namespace

Parsed<double> parse_any_number(std::string_view text, DecimalMark mark) {
  Decimal decimal;
  if (!DecimalScanner(text, mark).scan(decimal)) return {};
  if (decimal.mantissa == 0) return {decimal.negative ? -0.0 : 0.0, NumberFault::none};
  if (decimal.significant <= digits_that_fit && decimal.mantissa <= exact_integers &&
      decimal.exponent >= -22 && decimal.exponent <= 22) {
    // Both factors are exact, so the one operation rounds once, to the nearest double.
    const auto whole = static_cast<double>(decimal.mantissa);
    const double value = decimal.exponent < 0
                             ? whole / exact_tens[static_cast<std::size_t>(-decimal.exponent)]
                             : whole * exact_tens[static_cast<std::size_t>(decimal.exponent)];
    return {decimal.negative ? -value : value, NumberFault::none};
  }
  if (mark == DecimalMark::point) return parse_long_number(text);
  std::string pointed(text);
  std::replace(pointed.begin(), pointed.end(), ',', '.');
  return parse_long_number(pointed);
}

Parsed<std::size_t> parse_size(std::string_view text) {
  std::size_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return {};
  if (error != std::errc()) return {0, NumberFault::out_of_range};
  return {value, NumberFault::none};
}

void append_shortest(std::string& out, double value) {
  assert(std::isfinite(value));
  if (value == 0) value = 0;  // drops the sign of -0
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e15);
  std::array<char, 64> text;
  const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value, format);
  out.append(text.data(), result.ptr);
}

std::string shortest_text(double value) {
  std::string out;
  append_shortest(out, value);
  return out;
}

namespace {

// Scaled by its decimals a number of the size of rainfall is a whole number and a rest. The product
// is right to a unit in its last place, so the rest tells which way to round, unless it is as near
// to a half as that.
bool append_fixed_quickly(std::string& out, double value, int decimals) {
  constexpr std::array<std::uint64_t, 7> powers{1, 10, 100, 1000, 10'000, 100'000, 1'000'000};
  constexpr double largest = 1e12;
  if (decimals >= static_cast<int>(powers.size())) return false;
  const std::uint64_t power = powers[static_cast<std::size_t>(decimals)];
  const double scaled = std::abs(value) * static_cast<double>(power);
  if (!(scaled < largest)) return false;
  const double whole = std::floor(scaled);
  const double rest = scaled - whole;
  if (std::abs(rest - 0.5) <= scaled * 0x1p-52) return false;
  const std::uint64_t units = static_cast<std::uint64_t>(whole) + (rest > 0.5 ? 1 : 0);
  std::array<char, 32> text;
  char* at = text.data();
  if (value < 0 && units > 0) *at++ = '-';
  at = std::to_chars(at, text.data() + text.size(), units / power).ptr;
  if (decimals > 0) {
    *at++ = '.';
    std::uint64_t rest_units = units % power;
    for (char* digit = at + decimals; digit > at; rest_units /= 10)
      *--digit = static_cast<char>('0' + rest_units % 10);
    at += decimals;
  }
  out.append(text.data(), at);
  return true;
}

}  // namespace

void append_fixed(std::string& out, double value, int decimals) {
  assert(std::isfinite(value) && decimals >= 0 && decimals <= 100);
  if (append_fixed_quickly(out, value, decimals)) return;
  std::array<char, 512> text;  // 309 digits, a point, 100 decimals and a sign
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value,
                                    std::chars_format::fixed, decimals);
  std::string_view written(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
  if (written.find_first_not_of("-0.") == std::string_view::npos && written.front() == '-') {
    written.remove_prefix(1);
  }
  out += written;
}

std::string fixed_text(double value, int decimals) {
  std::string out;
  append_fixed(out, value, decimals);
  return out;
}

std::string significant_text(double value, int digits) {
  assert(std::isfinite(value) && digits >= 1);
  // The exponent is that of the rounded value: 9.996 with three digits is 1.00e+01.
  std::array<char, 512> text;
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value,
                                    std::chars_format::scientific, digits - 1);
  const std::string_view written(text.data(), static_cast<std::size_t>(result.ptr - text.data()));
  const std::size_t at = written.rfind('e') + 1;
  int exponent = 0;
  std::from_chars(text.data() + at + (written[at] == '+' ? 1 : 0), result.ptr, exponent);
  return fixed_text(value, std::clamp(digits - 1 - exponent, 0, 100));
}

}  // namespace thiessen

#include "base/number.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

namespace {

__extension__ using Product = unsigned __int128;

/// A number as digits / 10^decimals, without zeros at the end of its decimals.
struct PlainDigits {
  std::uint64_t digits;
  int decimals;
};

/// Takes so many zeros off the end of the decimals, if they are there.
template <int zeros, std::uint32_t power>
void trim(PlainDigits& number) {
  if (number.decimals < zeros || number.digits % power != 0) return;
  number.digits /= power;
  number.decimals -= zeros;
}

/// Takes all zeros off the end of the decimals, of which there are less than 16.
void trim_zeros(PlainDigits& number) {
  trim<8, 100'000'000>(number);
  trim<4, 10'000>(number);
  trim<2, 100>(number);
  trim<1, 10>(number);
}

/// The fewest digits that read back to the value, and of those the nearest. Requires 1e-6 <= value
/// < 1e15. Returns false for powers of two, below which doubles lie closer together than above.
///
/// All that reads back to the value lies within half a step between doubles of it. The step is at
/// least one unit of the last decimal that is looked at, and less than ten. So one multiple of ten
/// units at most reads back, and it is the shortest text; where there is none the nearest multiple
/// of one unit is. (R. Giulietti, The Schubfach way to render doubles, 2020.) In this range 5 to
/// the power of the decimals is a whole number, so that all of it is exact.
bool fewest_digits(double value, PlainDigits& found) {
  static constexpr auto fives = [] {
    std::array<std::uint64_t, 23> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 5 * powers[i - 1];
    return powers;
  }();
  constexpr std::uint64_t hidden_bit = std::uint64_t{1} << 52;
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const std::uint64_t fraction = bits & (hidden_bit - 1);
  if (fraction == 0) return false;
  const std::uint64_t mantissa = fraction | hidden_bit;
  const int exponent = static_cast<int>(bits >> 52) - 1075;  // of 2, -72 to -3: the step
  const int decimals = -((exponent * 78'913) >> 18);         // log10(2) = 78913 / 2^18, nearly
  const std::uint64_t five = fives[static_cast<std::size_t>(decimals)];
  // The value in units is `whole` and `rest` of 2^shift parts; half a step is 2 * five parts.
  const int shift = 2 - exponent - decimals;
  const std::uint64_t quarters = 4 * mantissa;
  const auto scaled = Product{quarters} * five;
  const auto whole = static_cast<std::uint64_t>(scaled >> shift);
  const std::uint64_t unit = std::uint64_t{1} << shift;
  const std::uint64_t rest = static_cast<std::uint64_t>(scaled) & (unit - 1);
  // What is half a step away reads back where the value's last bit is 0.
  const std::uint64_t reach = 2 * five - mantissa % 2;
  const std::uint64_t tens = whole / 10;
  const std::uint64_t above_ten = (whole % 10) * unit + rest;
  if (above_ten <= reach || 10 * unit - above_ten <= reach) {
    found = {above_ten <= reach ? tens : tens + 1, decimals - 1};
    trim_zeros(found);
  } else {
    const bool up = 2 * rest > unit || (2 * rest == unit && whole % 2 != 0);
    found = {whole + (up ? 1 : 0), decimals};
  }
  return true;
}

/// The digits of 00 to 99, one pair after the other.
constexpr auto pairs_of_digits = [] {
  std::array<char, 200> digits{};
  for (std::size_t i = 0; i < 100; ++i) {
    digits[2 * i] = static_cast<char>('0' + i / 10);
    digits[2 * i + 1] = static_cast<char>('0' + i % 10);
  }
  return digits;
}();

/// Writes a number below 10^8 with all 8 digits.
void write_eight(char* at, std::uint32_t number) {
  const std::uint32_t high = number / 10'000;
  const std::uint32_t low = number % 10'000;
  std::memcpy(at, &pairs_of_digits[std::size_t{2} * (high / 100)], 2);
  std::memcpy(at + 2, &pairs_of_digits[std::size_t{2} * (high % 100)], 2);
  std::memcpy(at + 4, &pairs_of_digits[std::size_t{2} * (low / 100)], 2);
  std::memcpy(at + 6, &pairs_of_digits[std::size_t{2} * (low % 100)], 2);
}

constexpr int most_digits = 17;

/// How many digits a number of at most 17 has.
int digits_of(std::uint64_t number) {
  static constexpr auto tens = [] {
    std::array<std::uint64_t, most_digits + 1> powers{1};
    for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
    return powers;
  }();
  const int nearly =
      (static_cast<int>(std::bit_width(number)) * 1233) >> 12;  // log10(2) = 1233 / 2^12, nearly
  return nearly + (number >= tens[static_cast<std::size_t>(nearly)] ? 1 : 0);
}

/// Writes a number above 0 of at most 17 digits, 15 of them before the point; returns where its
/// text ends. Requires room for 48 characters: copies of one length, which may write more than
/// there is, take less time than copies of the right one.
char* write_plain(char* at, const PlainDigits& number) {
  constexpr std::uint32_t eight = 100'000'000;
  constexpr std::size_t copied = 20;
  std::array<char, 48> digits{};
  const std::uint64_t high = number.digits / eight;
  digits[0] = static_cast<char>('0' + high / eight);
  write_eight(&digits[1], static_cast<std::uint32_t>(high % eight));
  write_eight(&digits[9], static_cast<std::uint32_t>(number.digits % eight));
  const int count = digits_of(number.digits);
  const char* from = &digits[static_cast<std::size_t>(most_digits - count)];
  const int whole = count - number.decimals;
  if (whole <= 0) {
    std::memcpy(at, "0.0000000", 8);  // 1e-6 has five zeros after the point
    at += 2 - whole;
  } else {
    std::memcpy(at, from, copied);
    at += whole;
    from += whole;
    if (number.decimals == 0) return at;
    *at++ = '.';
  }
  std::memcpy(at, from, copied);
  return at + std::min(count, number.decimals);
}

}  // namespace

void append_shortest(std::string& out, double value) {
  assert(std::isfinite(value));
  if (value == 0) value = 0;  // drops the sign of -0
  const double size = std::abs(value);
  const bool plain = size == 0 || (size >= 1e-6 && size < 1e15);
  std::array<char, 64> text;
  char* end = text.data();
  PlainDigits number{};
  if (plain && size != 0 && fewest_digits(size, number)) {
    if (value < 0) *end++ = '-';
    end = write_plain(end, number);
  } else {
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    end = std::to_chars(end, end + text.size(), value, format).ptr;
  }
  out.append(text.data(), static_cast<std::size_t>(end - text.data()));
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

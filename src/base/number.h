#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace thiessen {

/// This file reads and writes numbers as text, in the same way in every locale.
///
/// A number is `[+-] digits [. digits] [e [+-] digits]`, with digits on at least one side of the
/// point: 5, 5., .5, +5, 1e+5, 007 and any count of digits. Refused are blanks, nan, inf,
/// hexadecimal, 1_000, 1,234.5, and digits that are not ASCII.

/// The character that separates the whole part from the fraction.
enum class DecimalMark : char { point = '.', comma = ',' };

/// Why a text is not read as a number.
enum class NumberFault : std::uint8_t {
  none,
  not_a_number,  ///< the text is outside the grammar
  out_of_range,  ///< a number, but too large for the type, or too small without being zero
};

/// A number that was read, or the reason why there is none.
template <typename T>
struct Parsed {
  T value = {};
  NumberFault fault = NumberFault::not_a_number;

  explicit operator bool() const { return fault == NumberFault::none; }
};

/// Reads a number in its general form: with a sign, an exponent or many digits. parse_number calls
/// it for texts that are not plain and short.
Parsed<double> parse_any_number(std::string_view text, DecimalMark mark);

/// Reads the double nearest to the number that the text names, ties to even. The whole text must be
/// the number. Cost: linear in the digits; about 4 ns for readings such as 0 and 12.5, which are
/// read inline.
inline Parsed<double> parse_number(std::string_view text, DecimalMark mark = DecimalMark::point) {
  static constexpr std::array<double, 16> tens = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                  1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  if (text.empty() || text.size() >= tens.size()) return parse_any_number(text, mark);
  const char* at = text.data();
  const char* const end = at + text.size();
  std::int64_t digits = 0;  // at most 15, so exact as a double, and the division rounds once
  const auto take_digits = [&] {
    for (; at != end && *at >= '0' && *at <= '9'; ++at) digits = digits * 10 + (*at - '0');
  };
  take_digits();
  if (at == end) return {static_cast<double>(digits), NumberFault::none};
  if (*at == static_cast<char>(mark) && text.size() > 1) {
    const char* const fraction = ++at;
    take_digits();
    const auto scale = static_cast<std::size_t>(at - fraction);
    if (at == end) return {static_cast<double>(digits) / tens[scale], NumberFault::none};
  }
  return parse_any_number(text, mark);
}

/// How many bytes `parse_padded_number` may read.
constexpr std::size_t number_padding = 8;

/// Reads a number as parse_number does, but faster. Requires that number_padding bytes can be read
/// at text.data(), whatever the text's size. Texts of at most number_padding characters are read
/// without a branch on their length, so short numbers of mixed lengths take half the time.
inline Parsed<double> parse_padded_number(std::string_view text,
                                          DecimalMark mark = DecimalMark::point) {
  static constexpr std::array<double, 8> tens = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7};
  constexpr std::uint64_t each = 0x0101010101010101;
  const std::size_t size = text.size();
  if (std::endian::native != std::endian::little || size - 1 >= number_padding) {
    return parse_number(text, mark);
  }
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, text.data(), sizeof bytes);
  const std::size_t unused = 8 * (number_padding - size);
  std::uint64_t digits = bytes << unused | ('0' * each >> 1) >> (63 - unused);  // zeros before

  const std::uint64_t other = digits ^ each * static_cast<unsigned char>(mark);
  const std::uint64_t marks = (other - each) & ~other & 0x80 * each;  // its lowest bit is right
  const std::uint64_t at_mark = (marks & (0 - marks)) >> 7;
  const std::uint64_t before = at_mark - 1;
  const std::uint64_t without =
      (digits & ~(before | at_mark * 0xFF)) | (digits & before) << 8 | '0';
  digits = marks != 0 ? without : digits;
  const auto decimals =
      marks != 0 ? 7 - static_cast<std::size_t>(std::countr_zero(at_mark)) / 8 : 0;

  digits ^= '0' * each;
  const bool plain = ((digits | (digits + 0x76 * each)) & 0x80 * each) == 0;
  if (!plain || (marks != 0 && size == 1)) return parse_any_number(text, mark);
  digits = digits * 10 + (digits >> 8);
  constexpr std::uint64_t pairs = 0x000000FF000000FF;
  const std::uint64_t number =
      ((digits & pairs) * 0x000F424000000064 + ((digits >> 16) & pairs) * 0x0000271000000001) >> 32;
  return {static_cast<double>(static_cast<std::int64_t>(number)) / tens[decimals],
          NumberFault::none};
}

/// Reads a whole number in plain ASCII digits, without a sign.
Parsed<std::size_t> parse_size(std::string_view text);

/// Writes the fewest digits that read back to the same double: plain (0.000001, 1000000) where 1e-6
/// <= |value| < 1e15, otherwise with an exponent (1e+15, 2.5e-07). Zero is "0", whatever its sign.
/// Requires a finite value.
std::string shortest_text(double value);
/// Appends what shortest_text returns.
void append_shortest(std::string& out, double value);

/// Writes the value with so many decimals (at most 100), correctly rounded, ties to even; never
/// "-0.000". Requires a finite value.
std::string fixed_text(double value, int decimals);
/// Appends what fixed_text returns.
void append_fixed(std::string& out, double value, int decimals);

/// Writes the value rounded to so many digits that tell, and with all digits before the point:
/// three of 0.012346 are 0.0123, of 9.996 they are 10.0, and of 123456 they are 123456. Values that
/// need more than 100 decimals for that get 100. Requires a finite value and at least one digit.
std::string significant_text(double value, int digits);

}  // namespace thiessen

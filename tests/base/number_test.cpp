#include "base/number.h"

#include <gtest/gtest.h>

#include <array>
#include <cfloat>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace thiessen {
namespace {

void expect_number(std::string_view text, double value) {
  const Parsed<double> parsed = parse_number(text);
  ASSERT_TRUE(parsed) << text;
  EXPECT_EQ(parsed.value, value) << text;
}

TEST(Number, reads_every_form_of_the_grammar) {
  expect_number("0", 0);
  expect_number("007", 7);
  expect_number("12.5", 12.5);
  expect_number(".5", 0.5);
  expect_number("5.", 5);
  expect_number("+5", 5);
  expect_number("-5", -5);
  expect_number("1e5", 1e5);
  expect_number("1E+5", 1e5);
  expect_number("1.e-2", 0.01);
  expect_number("-.5e1", -5);
  expect_number("123456789012345", 123456789012345.0);
  expect_number("1234567890123456", 1234567890123456.0);
}

TEST(Number, refuses_what_is_outside_the_grammar) {
  for (const char* text :
       {"",    " ",       "1 ",    " 1",    "+",   "-",    ".",        "e5",   "1e",    "1e+",
        "--1", "+-1",     "nan",   "NaN",   "inf", "-inf", "infinity", "0x10", "0x1p3", "1_000",
        "1,5", "1,234.5", "1.2.3", "1e5.5", "1d5", "１２", "١٢",       "१",    "½",     "1e5e5"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::not_a_number) << text;
  }
  EXPECT_FALSE(parse_number(std::string_view("1\0002", 3)));
}

TEST(Number, tells_too_large_and_too_small_from_no_number) {
  for (const char* text : {"1e309", "1e400", "-1e400", "1e99999999999999999999", "1e-400",
                           "1e-99999999999999999999", "2e308"}) {
    EXPECT_EQ(parse_number(text).fault, NumberFault::out_of_range) << text;
  }
  expect_number("1.7976931348623157e308", DBL_MAX);
  expect_number("5e-324", 5e-324);
  expect_number("0e400", 0);
  expect_number("0e-99999999999999999999", 0);
}

TEST(Number, keeps_the_sign_of_zero) {
  EXPECT_TRUE(std::signbit(parse_number("-0").value));
  EXPECT_TRUE(std::signbit(parse_number("-0.000").value));
  EXPECT_FALSE(std::signbit(parse_number("0").value));
}

TEST(Number, rounds_any_count_of_digits_once) {
  // 2^53 + 1 lies halfway between two doubles, and goes to the even one; a hair more goes up.
  expect_number("9007199254740993", 9007199254740992.0);
  expect_number("9007199254740993.00000000000000000000001", 9007199254740994.0);
  expect_number("0." + std::string(5000, '0') + "1e5001", 1.0);
  expect_number(std::string(5000, '0') + "7.25", 7.25);
  expect_number("1." + std::string(5000, '0'), 1.0);
  expect_number("0.1234567890123456789012345678901234567890", 0.1234567890123456789);
  expect_number("1" + std::string(300, '0') + "e-300", 1.0);
}

TEST(Number, agrees_with_the_c_library_on_random_texts) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int i = 0; i < 200'000; ++i) {
    std::string text;
    const auto digits = [&](std::size_t most) {
      for (std::size_t n = random() % (most + 1); n > 0; --n) {
        text += static_cast<char>('0' + random() % 10);
      }
    };
    text += static_cast<char>('0' + random() % 10);
    digits(18);
    if (random() % 2 == 0) text += '.', digits(20);
    if (random() % 3 == 0) text += "e-" + std::to_string(random() % 30);
    ASSERT_EQ(parse_number(text).value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(Number, may_have_a_decimal_comma) {
  EXPECT_EQ(parse_number("1,5", DecimalMark::comma).value, 1.5);
  EXPECT_EQ(parse_number("-,5e1", DecimalMark::comma).value, -5);
  EXPECT_EQ(parse_number("9007199254740993,00000000000000000000001", DecimalMark::comma).value,
            9007199254740994.0);
  EXPECT_FALSE(parse_number("1.5", DecimalMark::comma)) << "it could be a thousands separator";
  EXPECT_FALSE(parse_number("1.234,5", DecimalMark::comma));
  EXPECT_TRUE(parse_number("15", DecimalMark::comma));
}

TEST(Size, is_made_of_digits_alone) {
  EXPECT_EQ(parse_size("018").value, 18u);
  EXPECT_EQ(parse_size("18446744073709551615").value, 18446744073709551615u);
  EXPECT_EQ(parse_size("18446744073709551616").fault, NumberFault::out_of_range);
  for (const char* text : {"", "+1", "-1", "1.0", " 1", "1 ", "1e3", "0x1"}) {
    EXPECT_EQ(parse_size(text).fault, NumberFault::not_a_number) << text;
  }
}

TEST(ShortestText, is_plain_in_the_middle_and_has_an_exponent_outside) {
  EXPECT_EQ(shortest_text(0), "0");
  EXPECT_EQ(shortest_text(-0.0), "0");
  EXPECT_EQ(shortest_text(0.1), "0.1");
  EXPECT_EQ(shortest_text(-1.5), "-1.5");
  EXPECT_EQ(shortest_text(1e6), "1000000");
  EXPECT_EQ(shortest_text(123456789012345.0), "123456789012345");
  EXPECT_EQ(shortest_text(999999999999999.9), "999999999999999.9");
  EXPECT_EQ(shortest_text(1e15), "1e+15");
  EXPECT_EQ(shortest_text(1e-6), "0.000001");
  EXPECT_EQ(shortest_text(2.5e-7), "2.5e-07");
  EXPECT_EQ(shortest_text(0.1 + 0.2), "0.30000000000000004");
}

TEST(ShortestText, reads_back_to_the_same_double) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (int i = 0; i < 100'000; ++i) {
    const double value = std::pow(10.0, exponent(random)) * (random() % 2 == 0 ? 1 : -1);
    const std::string text = shortest_text(value);
    ASSERT_EQ(parse_number(text).value, value) << text;
    ASSERT_EQ(std::strtod(text.c_str(), nullptr), value) << text;
  }
  for (const double value : {DBL_MAX, DBL_MIN, 5e-324}) {
    EXPECT_EQ(parse_number(shortest_text(value)).value, value);
  }
}

TEST(ShortestText, is_that_of_the_c_library) {
  const auto expect_alike = [](double value) {
    std::array<char, 64> text;
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
    ASSERT_EQ(shortest_text(value), std::string(text.data(), end));
  };
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-5.9, 14.9);
  for (int i = 0; i < 100'000; ++i) expect_alike(-std::pow(10.0, exponent(random)));
  for (int i = 0; i < 100'000; ++i)
    expect_alike(static_cast<double>(random() % 1'000'000'000) / std::pow(10.0, random() % 8));
  // Above and below a power of two doubles lie apart by different steps.
  for (int power = -19; power < 49; ++power) {
    double value = std::ldexp(1, power);
    for (int i = 0; i < 20; ++i) value = std::nextafter(value, 0);
    for (int i = 0; i < 40; ++i, value = std::nextafter(value, 1e15)) expect_alike(value);
  }
}

TEST(FixedText, rounds_the_exact_value_and_ties_to_even) {
  EXPECT_EQ(fixed_text(1.0005, 3), "1.000");  // the double is 1.00049999...
  EXPECT_EQ(fixed_text(0.125, 2), "0.12");
  EXPECT_EQ(fixed_text(0.375, 2), "0.38");
  EXPECT_EQ(fixed_text(2.5, 0), "2");
  EXPECT_EQ(fixed_text(0.9996, 3), "1.000");
  EXPECT_EQ(fixed_text(12.0625, 3), "12.062");
  EXPECT_EQ(fixed_text(1e22, 1), "10000000000000000000000.0");
  EXPECT_EQ(fixed_text(DBL_MAX, 100).size(), 309u + 1 + 100);
  EXPECT_EQ(fixed_text(0.1, 20), "0.10000000000000000555");
}

// As printf has them, which rounds the exact value, too.
TEST(FixedText, rounds_numbers_of_any_size_as_printf_does) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int i = 0; i < 100'000; ++i) {
    const int decimals = i % 9;
    const double size = std::pow(10, i % 17);
    // Every third number is a tie for few decimals.
    const double value = i % 3 == 0 ? std::round(any(random) * 4096) / 64 : any(random) * size;
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
    std::string expected = text.data();
    if (expected.find_first_not_of("-0.") == std::string::npos && expected.front() == '-')
      expected.erase(0, 1);
    ASSERT_EQ(fixed_text(value, decimals), expected);
  }
}

TEST(FixedText, never_shows_a_negative_zero) {
  EXPECT_EQ(fixed_text(-0.0, 3), "0.000");
  EXPECT_EQ(fixed_text(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed_text(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed_text(-0.4, 0), "0");
}

TEST(SignificantText, has_so_many_digits_that_tell_and_all_before_the_point) {
  EXPECT_EQ(significant_text(0.0123456, 3), "0.0123");
  EXPECT_EQ(significant_text(1.25, 2), "1.2");
  EXPECT_EQ(significant_text(-42, 4), "-42.00");
  EXPECT_EQ(significant_text(1000, 1), "1000");
  EXPECT_EQ(significant_text(123456.7, 3), "123457");
  EXPECT_EQ(significant_text(0, 3), "0.00");
  EXPECT_EQ(significant_text(5e-324, 3), "0." + std::string(100, '0'));
}

TEST(SignificantText, has_no_digit_more_where_rounding_makes_a_power_of_ten) {
  EXPECT_EQ(significant_text(9.994, 3), "9.99");
  EXPECT_EQ(significant_text(9.996, 3), "10.0");
  EXPECT_EQ(significant_text(99.96, 3), "100");
  EXPECT_EQ(significant_text(0.0996, 2), "0.10");
  EXPECT_EQ(significant_text(-0.9996, 3), "-1.00");
}

TEST(Number, is_the_same_in_a_locale_of_commas) {
  const char* found = nullptr;
  for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "tr_TR.UTF-8"}) {
    if (found == nullptr) found = std::setlocale(LC_ALL, name);
  }
  if (found == nullptr) GTEST_SKIP() << "no such locale is installed";
  expect_number("1.5", 1.5);
  expect_number("0.12345678901234567890123", 0.12345678901234567890123);
  EXPECT_EQ(shortest_text(1234.5), "1234.5");
  EXPECT_EQ(fixed_text(1234.5, 2), "1234.50");
  std::setlocale(LC_ALL, "C");
}

TEST(ParsePaddedNumber, is_the_same_as_without_padding) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  constexpr std::string_view letters = "00123456789..,,-+e/:";
  for (int i = 0; i < 1'000'000; ++i) {
    std::string text;
    for (auto size = random() % 10; size > 0; --size) text += letters[random() % letters.size()];
    const std::size_t size = text.size();
    for (std::size_t k = 0; k < number_padding; ++k) text += "7.\x80\xFF,"[random() % 5];
    const std::string_view number = std::string_view(text).substr(0, size);
    for (const DecimalMark mark : {DecimalMark::point, DecimalMark::comma}) {
      const Parsed<double> expected = parse_number(number, mark);
      const Parsed<double> found = parse_padded_number(number, mark);
      ASSERT_EQ(found.fault, expected.fault) << number;
      ASSERT_EQ(found.value, expected.value) << number;
    }
  }
}

TEST(ParsePaddedNumber, knows_every_short_number_of_plain_digits) {
  for (int tenths = 0; tenths < 100'000; ++tenths) {
    const std::string text = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
    const auto found =
        parse_padded_number(std::string_view(text + "12345678").substr(0, text.size()));
    ASSERT_TRUE(found) << text;
    ASSERT_EQ(found.value, tenths / 10.0) << text;
  }
}

}  // namespace
}  // namespace thiessen

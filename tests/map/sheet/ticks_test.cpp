#include "map/sheet/ticks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace thiessen {
namespace {

std::vector<std::string> texts(double least, double largest, int classes = 9) {
  std::vector<std::string> result;
  for (const RoundValue& tick : round_scale(least, largest, classes)) result.push_back(tick.text());
  return result;
}

using Texts = std::vector<std::string>;

TEST(Ticks, are_round_and_hold_the_values) {
  EXPECT_EQ(texts(39, 105), (Texts{"30", "40", "50", "60", "70", "80", "90", "100", "110"}));
  EXPECT_EQ(texts(0, 1), (Texts{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
  EXPECT_EQ(texts(0.3, 0.6, 5), (Texts{"0.3", "0.4", "0.5", "0.6"}));
  EXPECT_EQ(texts(0, 135), (Texts{"0", "20", "40", "60", "80", "100", "120", "140"}));
  EXPECT_EQ(texts(-3, 4, 4), (Texts{"-4", "-2", "0", "2", "4"}));
  EXPECT_EQ(texts(1e12, 3e12, 4), (Texts{"1e12", "1.5e12", "2e12", "2.5e12", "3e12"}));
}

TEST(Ticks, one_value_gives_one_tick) {
  EXPECT_EQ(texts(62.5, 62.5), Texts{"62.5"});
  EXPECT_EQ(texts(0, 0), Texts{"0"});
  EXPECT_EQ(texts(7.1, std::nextafter(7.1, 8)), Texts{"7.1"});
  EXPECT_EQ(texts(5e-324, 1e-323).size(), 1u);
}

TEST(Ticks, hold_any_range_in_at_most_the_classes_asked_for) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> power(-250, 250);
  std::uniform_real_distribution<double> share(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const double largest = std::pow(10, power(random));
    const double least = largest * share(random);
    const int classes = 2 + i % 9;
    const auto ticks = round_scale(least, largest, classes);
    if (ticks.size() == 1) continue;
    ASSERT_LE(ticks.size(), static_cast<std::size_t>(classes) + 1);
    ASSERT_GE(ticks.size(), 2u);
    ASSERT_LE(ticks.front().value(), least);
    ASSERT_GE(ticks.back().value(), largest);
    ASSERT_GT(ticks[1].value(), least) << "a class without values below";
    ASSERT_LT(ticks[ticks.size() - 2].value(), largest) << "a class without values above";
  }
}

TEST(Ticks, extreme_readings_do_not_overflow) {
  EXPECT_GE(round_scale(0, 1.7e308, 9).size(), 2u);
  EXPECT_GE(round_scale(-1.7e308, 1.7e308, 9).size(), 2u);
}

TEST(Ticks, decimals_are_exact) {
  EXPECT_EQ(decimal_text(15, -1), "1.5");
  EXPECT_EQ(decimal_text(-5, -2), "-0.05");
  EXPECT_EQ(decimal_text(1200, -2), "12");
  EXPECT_EQ(decimal_text(3, 4), "30000");
  EXPECT_EQ(decimal_text(25, 20), "2.5e21");
  EXPECT_EQ(decimal_text(5, -12), "5e-12");
  EXPECT_EQ(decimal_text(0, 5), "0");
}

TEST(Ticks, round_below_is_the_largest_of_one_two_five) {
  EXPECT_EQ(round_below(1).text(), "1");
  EXPECT_EQ(round_below(1.99).text(), "1");
  EXPECT_EQ(round_below(4.99).text(), "2");
  EXPECT_EQ(round_below(999).text(), "500");
  EXPECT_EQ(round_below(1000).text(), "1000");
  EXPECT_EQ(round_below(0.021).text(), "0.02");
}

TEST(TextsOf, have_equal_decimals_unless_one_has_an_exponent) {
  EXPECT_EQ(texts_of({{0, 0}, {5, -1}, {10, -1}, {125, -2}}),
            (std::vector<std::string>{"0.00", "0.50", "1.00", "1.25"}));
  EXPECT_EQ(texts_of({{5, 0}, {100, -1}}), (std::vector<std::string>{"5", "10"}));
  EXPECT_EQ(texts_of({{5, -1}, {1, 12}}), (std::vector<std::string>{"0.5", "1e12"}));
}

TEST(Rounding, down_and_up_keeps_so_many_digits) {
  EXPECT_EQ(round_down(0.0347, 1).text(), "0.03");
  EXPECT_EQ(round_up(0.0347, 1).text(), "0.04");
  EXPECT_EQ(round_up(0.0347, 2).text(), "0.035");
  EXPECT_EQ(round_up(996, 2).text(), "1000");
  EXPECT_EQ(round_down(-996, 2).text(), "-1000");
  for (const double exact : {0.1, 0.3, 0.7, 1e-7, 3e22}) {
    EXPECT_EQ(round_down(exact, 1).value(), exact);
    EXPECT_EQ(round_up(exact, 2).value(), exact);
  }
}

TEST(Roundest, is_a_multiple_of_the_largest_step_that_has_one_there) {
  EXPECT_EQ(roundest(1.6, 1.8, 2).text(), "2");
  EXPECT_EQ(roundest(2.4, 2.6, 2.8).text(), "2.5");
  EXPECT_EQ(roundest(4, 23.2, 42.4).text(), "20");
  EXPECT_EQ(roundest(97, 98, 102).text(), "100");
  EXPECT_EQ(roundest(0.123456, 0.123456, 0.123456).text(), "0.123456");
  EXPECT_EQ(roundest(0, 0, 0).text(), "0");
}

TEST(FewDigits, are_two_decimals_or_three_significant_digits) {
  const auto text = [](double value) { return few_digits(value).text(); };
  EXPECT_EQ(text(20.8 / 3), "6.93");
  EXPECT_EQ(text(12.34), "12.34");
  EXPECT_EQ(text(250), "250");
  EXPECT_EQ(text(1234.5678), "1234.57");
  EXPECT_EQ(text(-2.0 / 3), "-0.667");
  EXPECT_EQ(text(0.0123456), "0.0123");
  EXPECT_EQ(text(0), "0");
  EXPECT_EQ(text(1e-9 / 3), "3.33e-10");
  EXPECT_EQ(text(1e20), "1e20");
}

}  // namespace
}  // namespace thiessen

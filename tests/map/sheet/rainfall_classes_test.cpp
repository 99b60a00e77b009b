#include "map/sheet/rainfall_classes.h"

#include <gtest/gtest.h>

#include <limits>

#include "map/ink/contrast.h"
#include "map/ink/ink.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

ClassRule rule_of(ClassRule::Kind kind) {
  ClassRule rule;
  rule.kind = kind;
  return rule;
}

ClassRule rule_of_breaks(std::vector<double> breaks) {
  ClassRule rule = rule_of(ClassRule::Kind::breaks);
  rule.breaks = std::move(breaks);
  return rule;
}

TEST(RainfallClasses, of_readings_that_lie_evenly_are_equal) {
  const RainfallClasses classes({0.2, 0.4, none, 1}, {});
  EXPECT_EQ(classes.ticks(),
            (Texts{"0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.0"}));
  EXPECT_FALSE(classes.has_dry());
}

// The quantiles are 1.8, 2.6, 3.4 and 23.2; a twentieth to either side of them lie 1.6 and 2, 2.4
// and 2.8, 3.2 and 3.6, 4 and 42.4.
TEST(RainfallClasses, where_one_gauge_takes_the_scale_are_rounded_quantiles) {
  const std::vector<double> readings{1, 2, 3, 4, 100};
  const RainfallClasses classes(readings, {});
  EXPECT_EQ(classes.ticks(), (Texts{"1.0", "2.0", "2.5", "3.5", "20.0", "100.0"}));
  EXPECT_EQ(RainfallClasses(readings, rule_of(ClassRule::Kind::quantiles)).ticks(),
            classes.ticks());
  EXPECT_EQ(RainfallClasses(readings, rule_of(ClassRule::Kind::equal)).count(), 10u);
}

TEST(RainfallClasses, are_finer_where_half_of_the_readings_would_fall_into_one) {
  EXPECT_EQ(RainfallClasses({5, 25, 45, 65}, {}).ticks(),
            (Texts{"0", "10", "20", "30", "40", "50", "60", "70"}));
  EXPECT_EQ(RainfallClasses({31, 33, 37, 39, 100}, {}).count(), 14u) << "by 5 and not by 10";
  const RainfallClasses classes({20, 31, 33, 37, 39, 130}, {});
  EXPECT_EQ(classes.count(), 11u) << "by 10 and not by 20";
}

// Four times the median, 12, is not yet over it.
TEST(RainfallClasses, are_quantiles_only_above_four_times_the_median) {
  EXPECT_EQ(RainfallClasses({1, 3, 12}, {}).ticks().front(), "0");
  EXPECT_EQ(RainfallClasses({1, 3, 12.1}, {}).ticks().front(), "1.0");
}

TEST(RainfallClasses, law_1_a_value_on_a_bound_belongs_to_the_upper_class) {
  const RainfallClasses classes({}, rule_of_breaks({1, 2.5, 10}));
  ASSERT_EQ(classes.count(), 4u);
  EXPECT_EQ(classes.colour(0.9), classes.class_colour(0));
  EXPECT_EQ(classes.colour(1), classes.class_colour(1));
  EXPECT_EQ(classes.colour(2.4999), classes.class_colour(1));
  EXPECT_EQ(classes.colour(2.5), classes.class_colour(2));
  EXPECT_EQ(classes.colour(10), classes.class_colour(3));
}

TEST(RainfallClasses, law_2_classes_of_breaks_and_of_a_range_do_not_depend_on_the_readings) {
  const ClassRule breaks = rule_of_breaks({1, 5});
  EXPECT_EQ(RainfallClasses({0, 3}, breaks).ticks(), RainfallClasses({7, 900}, breaks).ticks());
  EXPECT_EQ(RainfallClasses({0, 3}, breaks).ticks(), (Texts{"0", "1", "5", ""}));
  ClassRule range;
  range.range = {0, 20};
  const RainfallClasses few({3}, range);
  const RainfallClasses many({3, 25, 26}, range);
  EXPECT_EQ(few.count(), 4u);
  EXPECT_EQ(few.ticks(), (Texts{"0", "5", "10", "15", "20"}));
  EXPECT_EQ(few.outside(), 0u);
  EXPECT_EQ(many.count(), 4u);
  EXPECT_EQ(many.outside(), 2u);
  EXPECT_EQ(many.ticks().back(), "\u2265 20");
  EXPECT_EQ(many.colour(26), many.class_colour(3));
}

TEST(RainfallClasses, law_3_zero_is_dry_in_every_palette) {
  for (const Palette palette :
       {Palette::viridis, Palette::blues, Palette::browns, Palette::greys}) {
    ClassRule rule;
    rule.palette = palette;
    const RainfallClasses classes({0, 0, 4, 8}, rule);
    EXPECT_TRUE(classes.has_dry());
    EXPECT_EQ(classes.colour(0), ink::dry);
    for (std::size_t i = 0; i < classes.count(); ++i) EXPECT_NE(classes.class_colour(i), ink::dry);
    EXPECT_GE(contrast(classes.class_colour(0), ink::dry), 1.4) << "in a grey print too";
  }
}

TEST(RainfallClasses, of_a_dry_day_are_none_but_the_dry_one) {
  const RainfallClasses classes({0, 0, none}, {});
  EXPECT_EQ(classes.count(), 0u);
  EXPECT_TRUE(classes.has_dry());
  EXPECT_EQ(RainfallClasses({none}, {}).count(), 0u);
  EXPECT_FALSE(RainfallClasses({none}, {}).has_dry());
}

TEST(RainfallClasses, of_equal_readings_are_one_with_one_text) {
  for (const auto kind : {ClassRule::Kind::chosen, ClassRule::Kind::quantiles}) {
    const RainfallClasses classes({4, 4}, rule_of(kind));
    EXPECT_EQ(classes.count(), 1u);
    EXPECT_EQ(classes.ticks(), (Texts{"4"}));
    EXPECT_EQ(classes.colour(4), classes.class_colour(0));
    EXPECT_EQ(RainfallClasses({20.8 / 3}, rule_of(kind)).ticks(), (Texts{"6.93"}))
        << "a mean of three readings";
  }
}

TEST(RainfallClasses, with_a_trace_begin_at_0_and_not_at_its_many_decimals) {
  const RainfallClasses classes({0, 1e-7, 3, 4, 5, 6, 50}, rule_of(ClassRule::Kind::quantiles));
  EXPECT_EQ(classes.ticks().front().substr(0, 1), "0");
  for (const std::string& tick : classes.ticks()) EXPECT_LE(tick.size(), 4U) << tick;
}

TEST(RainfallClasses, of_negative_values_have_no_dry_one) {
  const RainfallClasses classes({-2, 0, 2}, {});
  EXPECT_FALSE(classes.has_dry());
  EXPECT_NE(classes.colour(0), ink::dry);
  EXPECT_EQ(classes.ticks().front(), "-2.0");
}

// The quantiles of 1 and 9 are 2.6, 4.2, 5.8 and 7.4.
TEST(RainfallClasses, where_most_readings_are_the_same_tell_the_others) {
  const RainfallClasses classes({1, 1, 1, 1, 1, 1, 1, 1, 9}, {});
  EXPECT_EQ(classes.ticks(), (Texts{"1", "3", "4", "6", "7", "9"}));
}

// Steps of 5 from 5 to 40: the ends are no bounds.
TEST(RainfallClasses, meet_at_their_bounds) {
  const RainfallClasses classes({5, 15, 25, 38}, rule_of(ClassRule::Kind::equal));
  ASSERT_EQ(classes.ticks().front(), "5");
  EXPECT_EQ(classes.bounds(), (std::vector<double>{10, 15, 20, 25, 30, 35}));
}

}  // namespace
}  // namespace thiessen

#include "rainfall/series/time_range.h"

#include <gtest/gtest.h>

#include <string_view>

namespace thiessen {
namespace {

std::optional<IsoTime> limit(std::string_view text) {
  if (text.empty()) return std::nullopt;
  const ParsedTime parsed = parse_iso_time(text);
  EXPECT_TRUE(parsed) << text;
  return parsed.time;
}

bool holds(std::string_view from, std::string_view to, std::string_view time) {
  return TimeRange{limit(from), limit(to)}.holds(*limit(time));
}

bool is_empty(std::string_view from, std::string_view to) {
  return TimeRange{limit(from), limit(to)}.is_empty();
}

TEST(TimeRange, without_limits_holds_all) {
  EXPECT_TRUE(holds("", "", "2013"));
  EXPECT_TRUE(holds("2013", "", "9999-12-31"));
  EXPECT_TRUE(holds("", "2013", "0000"));
}

TEST(TimeRange, holds_all_of_a_day_a_month_a_year) {
  EXPECT_FALSE(holds("2013-08-31", "2013-08-31", "2013-08-30T23:59:59.999"));
  EXPECT_TRUE(holds("2013-08-31", "2013-08-31", "2013-08-31"));
  EXPECT_TRUE(holds("2013-08-31", "2013-08-31", "2013-08-31T00:00"));
  EXPECT_TRUE(holds("2013-08-31", "2013-08-31", "2013-08-31T23:59:59.999"));
  EXPECT_FALSE(holds("2013-08-31", "2013-08-31", "2013-09-01T00:00"));
  EXPECT_TRUE(holds("2013-08", "2013-08", "2013-08-31T23:00"));
  EXPECT_FALSE(holds("2013-08", "2013-08", "2013-07-31T23:00"));
  EXPECT_FALSE(holds("2013-08", "2013-08", "2013-09-01"));
  EXPECT_TRUE(holds("2013", "2013", "2013-12-31T23:00"));
  EXPECT_FALSE(holds("2013", "2013", "2014"));
}

TEST(TimeRange, gives_midnight_to_the_day_that_writes_it) {
  EXPECT_TRUE(holds("", "2013-08-31", "2013-08-31T24:00"));
  EXPECT_FALSE(holds("2013-09", "", "2013-08-31T24:00"));
}

TEST(TimeRange, with_times_of_the_day_is_between_moments_both_included) {
  const auto inside = [](std::string_view time) {
    return holds("2013-08-31T06:00", "2013-08-31T24:00", time);
  };
  EXPECT_FALSE(inside("2013-08-31T05:59:59.9"));
  EXPECT_TRUE(inside("2013-08-31T06:00"));
  EXPECT_TRUE(inside("2013-09-01T00:00"));
  EXPECT_FALSE(inside("2013-09-01T00:00:00.1"));
}

TEST(TimeRange, takes_a_day_month_or_year_for_its_beginning) {
  EXPECT_TRUE(holds("2013-08-31T00:00", "2013-08-31T00:00", "2013-08-31"));
  EXPECT_FALSE(holds("2013-08-31T00:01", "", "2013-08-31"));
  EXPECT_FALSE(holds("2013-08-15", "", "2013-08"));
  EXPECT_TRUE(holds("", "2013-08-15", "2013-08"));
  EXPECT_FALSE(holds("2013-02", "", "2013"));
}

TEST(TimeRange, compares_zones_where_both_have_one) {
  EXPECT_TRUE(holds("2013-08-31T06:00Z", "", "2013-08-31T08:00+02:00"));
  EXPECT_FALSE(holds("2013-08-31T06:00Z", "", "2013-08-31T07:59+02:00"));
  EXPECT_TRUE(holds("2013-08-31T06:00Z", "", "2013-08-31T06:00"));
  EXPECT_TRUE(holds("2013-08-31", "2013-08-31", "2013-08-31T00:30+02:00"));
}

TEST(TimeRange, is_empty_where_it_ends_before_it_begins) {
  EXPECT_TRUE(is_empty("2014", "2013"));
  EXPECT_TRUE(is_empty("2013-09", "2013-08-31"));
  EXPECT_TRUE(is_empty("2013-08-31T06:01", "2013-08-31T06:00"));
  EXPECT_TRUE(is_empty("2013-09-01T00:00:01", "2013-08-31T24:00"));
  EXPECT_FALSE(is_empty("2013", "2013"));
  EXPECT_FALSE(is_empty("2013-08-15", "2013-08"));
  EXPECT_FALSE(is_empty("2013-08", "2013-08-15"));
  EXPECT_FALSE(is_empty("2013-08-15T12:00", "2013-08-15"));
  EXPECT_FALSE(is_empty("2013-08-15", "2013-08-15T00:00"));
  EXPECT_FALSE(is_empty("2014", ""));
  EXPECT_FALSE(is_empty("", "2014"));
}

}  // namespace
}  // namespace thiessen

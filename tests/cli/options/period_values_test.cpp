#include "cli/options/period_values.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen::cli {
namespace {

std::string refusal(const OptionValue& value, const std::string& text) {
  try {
    value.read(text);
  } catch (const WrongValue& wrong) {
    return wrong.complaint;
  }
  return "";
}

TEST(PeriodValues, name_the_periods_of_totals) {
  std::optional<Every> every;
  const OptionValue value = periods(every);
  value.read("hour");
  EXPECT_EQ(every->unit, PeriodUnit::hours);
  EXPECT_EQ(every->hours, 1);
  value.read("36h");
  EXPECT_EQ(every->unit, PeriodUnit::hours);
  EXPECT_EQ(every->hours, 36);
  value.read("season");
  EXPECT_EQ(every->unit, PeriodUnit::season);
  EXPECT_EQ(every->hours, 1);
  for (const char* wrong : {"", "h", "0h", "8785h", "6 h", "6", "weeks", "-6h", "1.5h"}) {
    EXPECT_EQ(
        refusal(value, wrong),
        "wants hour, Nh (such as 6h, to 8784h), day, week, month, season, year or storm, not '" +
            std::string(wrong) + "'");
  }
}

TEST(PeriodValues, read_a_time_of_day) {
  std::int64_t start = -1;
  const OptionValue value = time_of_day(start);
  value.read("09:30");
  EXPECT_EQ(start, 34'200);
  value.read("00:00");
  EXPECT_EQ(start, 0);
  for (const char* wrong : {"", "9:00", "24:00", "09:60", "0900", "09:00:00", "09:", ":00"}) {
    EXPECT_EQ(
        refusal(value, wrong),
        "wants a time of day from 00:00 to 23:59, such as 09:00, not '" + std::string(wrong) + "'");
  }
}

TEST(PeriodValues, read_lengths_of_time) {
  EXPECT_EQ(duration_in("15min"), 900);
  EXPECT_EQ(duration_in("6h"), 21'600);
  EXPECT_EQ(duration_in("366d"), 31'622'400);
  for (const char* wrong : {"", "h", "6", "0h", "367d", "1.5h", "6 h", "-1h", "6H"})
    EXPECT_FALSE(duration_in(wrong)) << wrong;
}

TEST(PeriodValues, read_several_lengths_once_each) {
  std::vector<NamedDuration> lengths;
  const OptionValue value = durations(lengths);
  value.read("1h,24h,15min");
  ASSERT_EQ(lengths.size(), 3U);
  EXPECT_EQ(lengths[1].name, "24h");
  EXPECT_EQ(lengths[2].seconds, 900);
  EXPECT_EQ(refusal(value, "1h,60min"), "names 60min twice");
  EXPECT_EQ(refusal(value, "1h,,3h"),
            "wants lengths of time such as 1h,24h or 15min, not '1h,,3h'");
  EXPECT_EQ(lengths.size(), 3U);
}

}  // namespace
}  // namespace thiessen::cli

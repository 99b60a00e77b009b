#include "readings/totals/total_periods.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

namespace thiessen {
namespace {

constexpr int nine = 9 * 60;
constexpr int midnight = 24 * 60;
const StepLength daily{0, 86'400};
const ObservationHour at_end{std::nullopt, false, Stamp::end};

/// The period of a total, as its beginning and end.
std::string period(const std::string& time, const ObservationHour& hour,
                   std::optional<StepLength> step = daily, int days = 0) {
  try {
    const TotalPeriod found =
        TotalPeriods(hour, step).of(parse_iso_time(time).time, days, time, "t.csv", 3);
    return time_text(found.begin, TimePrecision::instant) + " " +
           time_text(found.end, TimePrecision::instant);
  } catch (const Error& error) {
    return error.what();
  }
}

TEST(TotalPeriods, of_dates_end_at_the_hour_of_that_day_or_the_day_after) {
  EXPECT_EQ(period("2020-03-01", {nine}), "2020-02-29T09:00 2020-03-01T09:00");
  EXPECT_EQ(period("2020-03-01", {nine, true}), "2020-03-01T09:00 2020-03-02T09:00");
  EXPECT_EQ(period("2020-03-01", {midnight}), "2020-03-01T00:00 2020-03-02T00:00");
  EXPECT_EQ(period("2020-03-01", {0}), "2020-02-29T00:00 2020-03-01T00:00");
  EXPECT_EQ(period("2020-03-01", {0, true}), "2020-03-01T00:00 2020-03-02T00:00");
}

TEST(TotalPeriods, of_several_days_end_where_one_would) {
  EXPECT_EQ(period("2020-03-02", {nine}, daily, 3), "2020-02-28T09:00 2020-03-02T09:00");
  EXPECT_EQ(period("2020-03-02T07:00", at_end, daily, 2), "2020-02-29T07:00 2020-03-02T07:00");
  EXPECT_EQ(period("2020-03-02T07:00", {}, daily, 2), "2020-03-01T07:00 2020-03-03T07:00");
}

TEST(TotalPeriods, are_as_long_as_the_step_of_their_file) {
  const StepLength week{0, 7 * 86'400};
  const StepLength month{1, 0};
  EXPECT_EQ(period("2020-01-08", {nine}, week), "2020-01-01T09:00 2020-01-08T09:00");
  EXPECT_EQ(period("2020-02-29", {midnight}, month), "2020-02-01T00:00 2020-03-01T00:00");
  EXPECT_EQ(period("2020-03-10", {midnight}, month), "2020-02-11T00:00 2020-03-11T00:00");
  EXPECT_EQ(period("2020-02", {midnight}, month), "2020-02-01T00:00 2020-03-01T00:00");
  EXPECT_EQ(period("2020-02", {nine}, month), "2020-01-31T09:00 2020-02-29T09:00");
  EXPECT_EQ(period("2020", {midnight}, StepLength{12, 0}), "2020-01-01T00:00 2021-01-01T00:00");
  EXPECT_EQ(period("2020-01-31T09:00", {}, month), "2020-01-31T09:00 2020-02-29T09:00");
  EXPECT_EQ(period("2020-02-29T09:00", at_end, month), "2020-01-31T09:00 2020-02-29T09:00");
}

TEST(TotalPeriods, with_a_clock_begin_or_end_there) {
  EXPECT_EQ(period("2020-03-01T07:00", {}), "2020-03-01T07:00 2020-03-02T07:00");
  EXPECT_EQ(period("2020-03-01T07:00", at_end), "2020-02-29T07:00 2020-03-01T07:00");
  EXPECT_EQ(period("2020-03-01T07:00+01:00", at_end), "2020-02-29T06:00 2020-03-01T06:00");
}

TEST(TotalPeriods, take_a_clock_of_midnight_for_none_where_an_hour_is_said) {
  EXPECT_EQ(period("2020-03-01T00:00", {nine}), "2020-02-29T09:00 2020-03-01T09:00");
}

TEST(TotalPeriods, are_not_guessed) {
  EXPECT_EQ(period("2020-03-01", {}),
            "t.csv:3: the total of '2020-03-01' has no hour, and nothing says when it was read");
  EXPECT_EQ(period("2020-03-01T07:00", {nine}),
            "t.csv:3: the total of '2020-03-01T07:00' has an hour of its own, and 'observed_at' "
            "says another");
  EXPECT_EQ(period("2020-03-01T07:00", {}, std::nullopt),
            "t.csv:3: nothing tells how long the total of '2020-03-01T07:00' is, for the totals "
            "have no regular step");
}

}  // namespace
}  // namespace thiessen

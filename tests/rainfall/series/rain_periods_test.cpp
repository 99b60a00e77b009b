#include "rainfall/series/rain_periods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/iso_time.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Values = std::vector<double>;
using Steps = std::vector<std::pair<std::string, Values>>;

std::vector<RainPeriod> periods_of(const Steps& steps, Totalling totalling) {
  std::vector<RainPeriod> taken;
  RainPeriods periods(totalling, "r.csv", [&](const RainPeriod& one) { taken.push_back(one); });
  for (const auto& [time, values] : steps) {
    RainStep step{time, {}, {}, {}};
    for (const double value : values) step.basins.push_back({value, 1, 1});
    periods.add(step);
  }
  Warnings warnings;
  periods.finish(warnings);
  return taken;
}

/// The totals of the first basin.
Steps totals_of(const Steps& steps, Totalling totalling) {
  Steps totals;
  for (const RainPeriod& period : periods_of(steps, totalling))
    totals.push_back({period.time, {period.basins.at(0).rainfall}});
  return totals;
}

std::string fault_of(const Steps& steps, Totalling totalling) {
  try {
    periods_of(steps, totalling);
  } catch (const Error& error) {
    return error.messages().at(0).sentence() + "; " + error.messages().at(0).hint.plain();
  }
  return "none";
}

const Totalling days{PeriodUnit::day, 0};
const Totalling months{PeriodUnit::month, 0};
const Totalling years{PeriodUnit::year, 0};

TEST(RainPeriods, are_days_months_or_years) {
  const Steps steps = {{"2013-08-30T12:00", {1}},
                       {"2013-08-31T00:00:07", {2}},
                       {"2013-08-31T23:59", {4}},
                       {"2013-09-01", {8}},
                       {"2014-09-01", {16}}};
  EXPECT_EQ(
      totals_of(steps, days),
      (Steps{{"2013-08-30", {1}}, {"2013-08-31", {6}}, {"2013-09-01", {8}}, {"2014-09-01", {16}}}));
  EXPECT_EQ(totals_of(steps, months),
            (Steps{{"2013-08", {7}}, {"2013-09", {8}}, {"2014-09", {16}}}));
  EXPECT_EQ(totals_of(steps, years), (Steps{{"2013", {15}}, {"2014", {16}}}));
}

TEST(RainPeriods, may_descend_and_come_in_any_order) {
  EXPECT_EQ(
      totals_of({{"2014-01", {1}}, {"2013-12", {2}}, {"2013-11", {4}}}, {PeriodUnit::year, 11}),
      (Steps{{"2014", {1}}, {"2013", {6}}}));
  EXPECT_EQ(totals_of({{"2013", {1}}, {"2015", {2}}, {"2014", {4}}}, years),
            (Steps{{"2013", {1}}, {"2015", {2}}, {"2014", {4}}}));
}

TEST(RainPeriods, are_those_of_the_times_as_written) {
  EXPECT_EQ(totals_of({{"2013-08-31T24:00", {1}},
                       {"2013-09-01T00:00+02:00", {2}},
                       {"2013-09-01T23:30-05:00", {4}},
                       {"20130902", {8}}},
                      days),
            (Steps{{"2013-08-31", {1}}, {"2013-09-01", {6}}, {"2013-09-02", {8}}}));
}

TEST(RainPeriods, have_no_total_where_a_step_has_no_value) {
  const auto periods = periods_of(
      {{"2013-01-01", {1, 5}}, {"2013-01-06", {none, 5}}, {"2013-02-01", {2, none}}}, months);
  ASSERT_EQ(periods.size(), 2u);
  EXPECT_TRUE(std::isnan(periods[0].basins[0].rainfall));
  EXPECT_EQ(periods[0].basins[0].missing, 1u);
  EXPECT_EQ(periods[0].basins[1].rainfall, 10);
  EXPECT_EQ(periods[0].basins[1].missing, 0u);
  EXPECT_EQ(periods[1].basins[0].rainfall, 2);
  EXPECT_TRUE(std::isnan(periods[1].basins[1].rainfall));
  EXPECT_EQ(periods[1].basins[1].missing, 1u);
}

TEST(RainPeriods, pass_over_as_many_steps_without_a_value_as_allowed) {
  const Steps steps = {
      {"2013-01-01", {1}}, {"2013-01-03", {none}}, {"2013-01-06", {none}}, {"2013-01-10", {2}}};
  EXPECT_TRUE(std::isnan(totals_of(steps, {PeriodUnit::month, 1})[0].second[0]));
  EXPECT_EQ(totals_of(steps, {PeriodUnit::month, 2}), (Steps{{"2013-01", {3}}}));
  EXPECT_EQ(periods_of(steps, {PeriodUnit::month, 2})[0].basins[0].missing, 2u);
}

TEST(RainPeriods, have_no_total_of_nothing) {
  EXPECT_TRUE(std::isnan(totals_of({{"2013-01-01", {none}}}, {PeriodUnit::month, 9})[0].second[0]));
  EXPECT_TRUE(periods_of({}, months).empty());
}

TEST(RainPeriods, do_not_depend_on_the_order_of_their_steps) {
  Steps steps;
  for (int i = 0; i < 31; ++i)
    steps.push_back({"2013-08-01", {i % 3 == 0 ? 1e9 + 0.1 * i : 1e-9 / (i + 1)}});
  const Steps forth = totals_of(steps, months);
  std::reverse(steps.begin(), steps.end());
  EXPECT_EQ(totals_of(steps, months), forth);
}

TEST(RainPeriods, add_a_century_of_tenths_without_loss) {
  Steps steps;
  for (int i = 0; i < 100'000; ++i) steps.push_back({"2013-08-01", {0.1}});
  // 0.1 is 5.6e-18 too much, 1e5 of them 5.6e-13 more than 10000, whose last place is 1.8e-12.
  EXPECT_EQ(totals_of(steps, years), (Steps{{"2013", {10000}}}));
}

/// A step of one millimetre on each day from the first to the last of a month's days.
void add_days(Steps& steps, const std::string& month, int first, int last) {
  for (int day = first; day <= last; ++day)
    steps.push_back({month + (day < 10 ? "-0" : "-") + std::to_string(day), {1}});
}

std::size_t missing_in(const std::vector<RainPeriod>& periods, const std::string& time) {
  for (const RainPeriod& period : periods) {
    if (period.time == time) return period.basins.at(0).missing;
  }
  ADD_FAILURE() << time << " is not there";
  return 0;
}

TEST(RainPeriods, law_1_AStepThatLacksCountsAsOneWithoutAValue) {
  Steps steps;
  add_days(steps, "2019-05", 1, 31);
  add_days(steps, "2019-06", 22, 30);
  add_days(steps, "2019-07", 1, 31);
  add_days(steps, "2019-09", 1, 29);
  const auto periods = periods_of(steps, months);
  ASSERT_EQ(periods.size(), 5u);
  EXPECT_EQ(periods[0].basins[0].rainfall, 31);
  EXPECT_EQ(missing_in(periods, "2019-06"), 21u);
  EXPECT_EQ(missing_in(periods, "2019-07"), 0u);
  EXPECT_EQ(periods[3].time, "2019-08");
  EXPECT_EQ(missing_in(periods, "2019-08"), 31u);
  EXPECT_EQ(missing_in(periods, "2019-09"), 1u);
  EXPECT_TRUE(std::isnan(periods[4].basins[0].rainfall));
}

TEST(RainPeriods, law_2_TheOrderOfTheFileDoesNotChangeWhatLacks) {
  Steps steps;
  add_days(steps, "2019-05", 3, 31);
  add_days(steps, "2019-07", 1, 30);
  std::reverse(steps.begin(), steps.end());
  const auto periods = periods_of(steps, months);
  ASSERT_EQ(periods.size(), 3u);
  EXPECT_EQ(periods[0].time, "2019-07");
  EXPECT_EQ(periods[1].time, "2019-06");
  EXPECT_EQ(missing_in(periods, "2019-07"), 1u);
  EXPECT_EQ(missing_in(periods, "2019-06"), 30u);
  EXPECT_EQ(missing_in(periods, "2019-05"), 2u);
}

TEST(RainPeriods, law_3_WhatIsNotAskedForDoesNotLack) {
  Steps steps;
  add_days(steps, "2019-05", 10, 31);
  add_days(steps, "2019-06", 1, 20);
  TimeRange range{parse_iso_time("2019-05-10").time, parse_iso_time("2019-06-20").time};
  const auto periods = periods_of(steps, {PeriodUnit::month, 0, range});
  EXPECT_EQ(missing_in(periods, "2019-05"), 0u);
  EXPECT_EQ(missing_in(periods, "2019-06"), 0u);
  range.from = parse_iso_time("2019-05-08").time;
  EXPECT_EQ(missing_in(periods_of(steps, {PeriodUnit::month, 0, range}), "2019-05"), 2u);
}

TEST(RainPeriods, count_months_that_lack_in_a_year) {
  Steps steps;
  for (const char* month : {"2019-03-31", "2019-04-30", "2019-05-31", "2019-06-30", "2019-07-31",
                            "2019-08-31", "2019-09-30", "2019-10-31", "2019-11-30", "2019-12-31"})
    steps.push_back({month, {1}});
  EXPECT_EQ(missing_in(periods_of(steps, years), "2019"), 2u);
}

TEST(RainPeriods, refuse_a_time_that_is_mistyped_by_ages) {
  Steps steps;
  add_days(steps, "2019-05", 1, 31);
  steps.push_back({"9019-06-01", {1}});
  EXPECT_EQ(fault_of(steps, days),
            "r.csv: no step lies between 2019-05-31 and 9019-06-01; is one of them mistyped?");
}

TEST(RainPeriods, refuse_one_that_comes_back) {
  EXPECT_EQ(fault_of({{"2013-08-01", {1}}, {"2013-09-01", {1}}, {"2013-08-02", {1}}}, months),
            "r.csv: time '2013-08-02' comes back to 2013-08 after another period has begun; sort "
            "the file by time");
  EXPECT_EQ(fault_of({{"2013-08-01", {1}}, {"2013-09-01", {1}}, {"2013-08-02", {1}}}, days),
            "none");
  EXPECT_EQ(fault_of({{"2013-08-01", {1}}, {"2013-09-01", {1}}, {"2013-08-02", {1}}}, years),
            "none");
}

TEST(RainPeriods, refuse_times_that_do_not_say_them) {
  EXPECT_EQ(fault_of({{"2013-08", {1}}}, days),
            "r.csv: time '2013-08' does not say the day; 'every' takes periods that are no "
            "shorter than the steps");
  EXPECT_EQ(fault_of({{"storm", {1}}}, years),
            "r.csv: time 'storm' is not written as ISO 8601 wants it; wanted: 2013, 2013-08, "
            "2013-08-31, 2013-08-31T06:00 or 20130831T0600; 'time_format' says how else, such as "
            "'%d/%m/%Y %H:%M'");
}

TEST(RainPeriods, midnight_ends_the_day_before_where_times_end_steps) {
  const Steps steps = {{"2013-08-30T12:00", {1}},
                       {"2013-08-31T00:00", {2}},
                       {"2013-08-31T12:00", {4}},
                       {"2013-09-01T00:00", {8}}};
  Totalling ends{PeriodUnit::day, 0, {}, Stamp::end};
  EXPECT_EQ(totals_of(steps, ends), (Steps{{"2013-08-30", {3}}, {"2013-08-31", {12}}}));
  ends.every = PeriodUnit::month;
  EXPECT_TRUE(std::isnan(totals_of(steps, ends).at(0).second.at(0))) << "August lacks 58 steps";
  ends.allowed_missing = 58;
  EXPECT_EQ(totals_of(steps, ends), (Steps{{"2013-08", {15}}}));
  ends.allowed_missing = 57;
  EXPECT_TRUE(std::isnan(totals_of(steps, ends).at(0).second.at(0)));
  EXPECT_EQ(
      totals_of({{"2013-08-31", {1}}, {"2013-09-01", {2}}}, {PeriodUnit::day, 0, {}, Stamp::end}),
      (Steps{{"2013-08-31", {1}}, {"2013-09-01", {2}}}))
      << "a date is the whole day";
}

TEST(RainPeriods, what_lies_beyond_a_range_does_not_lack_where_times_end_steps) {
  Totalling ends{PeriodUnit::day, 0, {}, Stamp::end};
  ends.range.from = parse_iso_time("2013-08-31T12:00").time;
  ends.range.to = parse_iso_time("2013-09-01T12:00").time;
  EXPECT_EQ(
      totals_of({{"2013-08-31T12:00", {1}}, {"2013-09-01T00:00", {2}}, {"2013-09-01T12:00", {4}}},
                ends),
      (Steps{{"2013-08-31", {3}}, {"2013-09-01", {4}}}));
}

/// The periods that are handed on by each step, parted by bars, and in the end.
std::string as_they_end(const Steps& steps, Totalling totalling) {
  std::string text;
  totalling.as_they_end = true;
  RainPeriods periods(totalling, "r.csv", [&](const RainPeriod& one) {
    text += ' ' + one.time + '-' + std::to_string(one.basins.at(0).missing);
  });
  for (const auto& [time, values] : steps) {
    RainStep step{time, {}, {}, {}};
    step.basins.push_back({values.at(0), 1, 1});
    periods.add(step);
    text += '|';
  }
  Warnings warnings;
  periods.finish(warnings);
  return text;
}

TEST(RainPeriods, are_handed_on_as_they_end_where_that_is_wanted) {
  const Steps steps = {{"2013-08-30T00:00", {1}}, {"2013-08-30T12:00", {1}},
                       {"2013-08-31T00:00", {1}}, {"2013-08-31T12:00", {1}},
                       {"2013-09-02T12:00", {1}}, {"2013-09-03T00:00", {1}}};
  EXPECT_EQ(as_they_end(steps, days),
            "||"
            " 2013-08-30-0||"
            " 2013-08-31-0 2013-09-01-2|"
            " 2013-09-02-1|"
            " 2013-09-03-1");
  EXPECT_EQ(as_they_end({{"2015", {1}}, {"2014", {1}}, {"2012", {1}}}, years),
            "| 2015-0| 2014-0 2013-1| 2012-0");
  EXPECT_EQ(as_they_end({}, days), "");
}

TEST(RainPeriods, may_leave_out_a_last_one_that_may_not_be_over) {
  Totalling whole = days;
  whole.whole_alone = true;
  const Steps steps = {{"2013-08-30T00:00", {1}},
                       {"2013-08-30T12:00", {2}},
                       {"2013-08-31T00:00", {4}},
                       {"2013-08-31T12:00", {8}}};
  EXPECT_EQ(totals_of(steps, whole), (Steps{{"2013-08-30", {3}}, {"2013-08-31", {12}}}));
  EXPECT_EQ(totals_of({steps.begin(), steps.end() - 1}, whole), (Steps{{"2013-08-30", {3}}}));
  EXPECT_EQ(totals_of({steps.begin(), steps.begin() + 1}, whole), Steps{});
  EXPECT_EQ(as_they_end({steps.begin(), steps.end() - 1}, whole), "|| 2013-08-30-0|");
  // In a file that descends the last one is the first in time, and nothing comes behind it.
  EXPECT_EQ(
      totals_of({{"2013-08-31T12:00", {1}}, {"2013-08-31T00:00", {2}}, {"2013-08-30T12:00", {4}}},
                whole)
          .size(),
      2U);
}

TEST(RainPeriods, rates_count_times_their_step) {
  Totalling days{PeriodUnit::day, 23, {}};
  days.depths.emplace(StepLength{0, 3'600}, StepLength{0, 900});
  const Steps quarters = {{"2020-01-01T00:00", {4}},
                          {"2020-01-01T00:15", {4}},
                          {"2020-01-01T00:30", {8}},
                          {"2020-01-01T00:45", {none}}};
  days.allowed_missing = 96;
  EXPECT_EQ(totals_of(quarters, days), (Steps{{"2020-01-01", {4}}})) << "1 + 1 + 2 mm";
}

TEST(RainPeriods, rates_of_days_count_times_the_days_of_their_month) {
  Totalling months{PeriodUnit::month, 0, {}};
  months.depths.emplace(StepLength{0, 86'400}, StepLength{1, 0});
  EXPECT_EQ(totals_of({{"2020-01", {4}}, {"2020-02", {4}}, {"2020-03", {4}}}, months),
            (Steps{{"2020-01", {124}}, {"2020-02", {116}}, {"2020-03", {124}}}));
}

Totalling days_of_hourly_rates() {
  Totalling days{PeriodUnit::day, 100, {}};
  days.rates = {StepLength{0, 3'600}, "mm/h"};
  days.as_they_end = true;
  return days;
}

// 4 mm/h in three steps of 15 minutes are 3 mm, and 8 mm/h in one of them 2 mm.
TEST(RainPeriods, rates_that_come_count_times_the_step_that_the_first_period_tells) {
  const Steps quarters = {{"2020-01-01T23:15", {4}},
                          {"2020-01-01T23:30", {4}},
                          {"2020-01-01T23:45", {4}},
                          {"2020-01-02T00:00", {8}}};
  EXPECT_EQ(totals_of(quarters, days_of_hourly_rates()),
            (Steps{{"2020-01-01", {3}}, {"2020-01-02", {2}}}));
}

TEST(RainPeriods, rates_have_no_totals_where_their_step_is_not_known_or_changes) {
  const std::string rates =
      "r.csv: the readings are rates in mm/h, whose totals want the length of each step, and ";
  const auto starts = [&](const Steps& steps, const std::string& why) {
    const std::string fault = fault_of(steps, days_of_hourly_rates());
    return fault.starts_with(rates + why) ? "so" : fault;
  };
  EXPECT_EQ(starts({{"2020-01-01T00:00", {4}}}, "one time tells none; "), "so");
  EXPECT_EQ(
      starts({{"2020-01-01T00:00", {4}}, {"2020-01-01T00:07", {4}}, {"2020-01-01T00:30", {4}}},
             "the times have no regular step; "),
      "so");
  EXPECT_EQ(starts({{"2020-01-01T22:00", {4}},
                    {"2020-01-01T23:00", {4}},
                    {"2020-01-02T00:00", {4}},
                    {"2020-01-02T00:15", {4}}},
                   "time '2020-01-02T00:15' in line 0 lies no whole steps of 1 hour from the one "
                   "before, which the times above tell; "),
            "so");
}

/// Steps of one millimetre each, so many seconds apart.
Steps steps_from(const std::string& first, int count, std::int64_t apart) {
  Steps steps;
  const std::int64_t begin = clock_seconds(parse_iso_time(first).time);
  for (int i = 0; i < count; ++i)
    steps.push_back({time_text(begin + apart * i, TimePrecision::instant), {1}});
  return steps;
}

Totalling days_from(std::int64_t day_start, PeriodUnit unit = PeriodUnit::day) {
  Totalling totalling;
  totalling.every = unit;
  totalling.every.day_start = day_start;
  totalling.every.has_day_start = true;
  return totalling;
}

constexpr std::int64_t hour = 3'600;

TEST(RainPeriods, of_days_that_begin_at_nine_have_the_hours_from_nine_to_nine) {
  const auto periods = periods_of(steps_from("2014-02-28T09:00", 48, hour), days_from(9 * hour));
  ASSERT_EQ(periods.size(), 2u);
  EXPECT_EQ(periods[0].time, "2014-02-28");
  EXPECT_EQ(periods[0].basins[0].rainfall, 24);
  EXPECT_EQ(iso_text(periods[0].begin.time), "2014-02-28T09:00");
  EXPECT_EQ(periods[1].time, "2014-03-01");
  EXPECT_EQ(periods[1].basins[0].missing, 0u);
}

TEST(RainPeriods, of_days_that_begin_at_nine_end_at_nine_where_times_end_steps) {
  Totalling ends = days_from(9 * hour);
  ends.stamp = Stamp::end;
  EXPECT_EQ(totals_of(steps_from("2014-02-28T10:00", 48, hour), ends),
            (Steps{{"2014-02-28", {24}}, {"2014-03-01", {24}}}));
}

TEST(RainPeriods, have_leap_days) {
  const auto whole = [](PeriodUnit unit, const char* first, int count) {
    Totalling totalling;
    totalling.every = unit;
    totalling.every.year_start = 10;
    return totals_of(steps_from(first, count, 86'400), totalling);
  };
  EXPECT_EQ(whole(PeriodUnit::season, "2015-12-01", 91), (Steps{{"2016-DJF", {91}}}));
  EXPECT_EQ(whole(PeriodUnit::year, "2015-10-01", 366), (Steps{{"2016", {366}}}));
  EXPECT_EQ(whole(PeriodUnit::week, "2016-02-29", 14),
            (Steps{{"2016-W09", {7}}, {"2016-W10", {7}}}));
  EXPECT_TRUE(std::isnan(whole(PeriodUnit::season, "2015-12-01", 90)[0].second[0]));
  EXPECT_TRUE(std::isnan(whole(PeriodUnit::year, "2015-10-02", 365)[0].second[0]));
}

TEST(RainPeriods, of_months_make_seasons_and_water_years) {
  Steps steps;
  for (const char* month : {"2013-10", "2013-11", "2013-12", "2014-01", "2014-02", "2014-03",
                            "2014-04", "2014-05", "2014-06", "2014-07", "2014-08", "2014-09"})
    steps.push_back({month, {1}});
  Totalling year = years;
  year.every.year_start = 10;
  EXPECT_EQ(totals_of(steps, year), (Steps{{"2014", {12}}}));
  const auto seasons = periods_of(steps, {PeriodUnit::season, 0});
  ASSERT_EQ(seasons.size(), 5u);
  EXPECT_EQ(seasons[0].time, "2013-SON");
  EXPECT_EQ(seasons[0].basins[0].missing, 1u);
  EXPECT_EQ(seasons[1].basins[0].rainfall, 3);
  EXPECT_EQ(seasons[4].time, "2014-SON");
  EXPECT_EQ(seasons[4].basins[0].missing, 2u);
}

TEST(RainPeriods, hand_on_hours_that_lack) {
  Steps steps = steps_from("2014-02-28T00:00", 24, hour);
  steps.erase(steps.begin() + 5, steps.begin() + 13);
  Totalling sixes = {PeriodUnit::hours, 1};
  sixes.every.hours = 6;
  const auto periods = periods_of(steps, sixes);
  ASSERT_EQ(periods.size(), 4u);
  EXPECT_EQ(periods[0].time, "2014-02-28T00:00");
  EXPECT_EQ(periods[0].basins[0].rainfall, 5);
  EXPECT_EQ(periods[1].time, "2014-02-28T06:00");
  EXPECT_EQ(periods[1].basins[0].missing, 6u);
  EXPECT_EQ(periods[2].basins[0].missing, 1u);
}

TEST(RainPeriods, law_4_an_hour_that_is_written_twice_is_two) {
  Steps steps;
  for (const char* zone : {"+02:00", "+01:00"}) {
    for (const char* minute : {"00", "15", "30", "45"})
      steps.push_back({"2019-10-27T02:" + std::string(minute) + zone, {1}});
  }
  EXPECT_EQ(totals_of(steps, {PeriodUnit::hours, 0}),
            (Steps{{"2019-10-27T02:00+02:00", {4}}, {"2019-10-27T02:00+01:00", {4}}}));
  steps.clear();
  for (const char* time :
       {"2019-10-27T00:00+02:00", "2019-10-27T01:00+02:00", "2019-10-27T02:00+02:00",
        "2019-10-27T02:00+01:00", "2019-10-27T03:00+01:00", "2019-10-27T04:00+01:00"})
    steps.push_back({time, {1}});
  Totalling threes = {PeriodUnit::hours, 0};
  threes.every.hours = 3;
  const auto periods = periods_of(steps, threes);
  EXPECT_EQ(periods.at(0).basins[0].rainfall, 4) << "0, 1 and twice 2";
  EXPECT_EQ(periods.at(1).basins[0].missing, 1u) << "5 is not there";
}

TEST(RainPeriods, law_5_no_step_lies_in_two_where_it_is_said_when_days_begin) {
  EXPECT_EQ(fault_of(steps_from("2014-02-28T00:00", 9, 6 * hour), days_from(9 * hour)),
            "r.csv: 2014-02-27 begins at 09:00, within one of the steps of 6 hours, of which one "
            "begins at 12:00; day_start = 12:00 has days begin where a step does");
  EXPECT_EQ(fault_of(steps_from("2014-02-28T00:00", 9, 24 * hour),
                     days_from(9 * hour, PeriodUnit::month)),
            "r.csv: 2014-02 begins at 09:00, within one of the steps of 1 day, of which one begins "
            "at 00:00; day_start = 00:00 has days begin where a step does");
  EXPECT_EQ(fault_of(steps_from("2014-02-28T00:00", 9, 6 * hour), days_from(12 * hour)), "none");
  EXPECT_EQ(
      fault_of({{"2014-02-28", {1}}}, days_from(9 * hour)),
      "r.csv: time '2014-02-28' does not say the hour, which hours and the start of days want; "
      "every = day sums dates, each of which is a day whenever it begins: leave 'day_start' "
      "out");
  Totalling ends = days_from(9 * hour);
  ends.stamp = Stamp::end;
  EXPECT_EQ(fault_of(steps_from("2014-02-28T00:00", 9, 6 * hour), ends),
            "r.csv: 2014-02-27 begins at 09:00, within one of the steps of 6 hours, of which one "
            "begins at 12:00; day_start = 12:00 has days begin where a step does");
}

TEST(RainPeriods, law_6_hours_hold_whole_steps) {
  const auto fault = [](int every, std::int64_t step, const char* first) {
    Totalling totalling = {PeriodUnit::hours, 0};
    totalling.every.hours = every;
    return fault_of(steps_from(first, 12, step), totalling);
  };
  EXPECT_EQ(fault(4, 3 * hour, "2014-02-28T00:00"),
            "r.csv: periods of 4 hours do not hold whole steps of 3 hours, which the file has; "
            "every = 6h takes whole steps");
  EXPECT_EQ(
      fault(1, 24 * hour, "2014-02-28T00:00"),
      "r.csv: periods of 1 hour do not hold whole steps of 1 day, which the file has; every = "
      "24h takes whole steps");
  EXPECT_EQ(
      fault(1, 900, "2014-02-28T00:07"),
      "r.csv: 2014-02-28T00:00 begins at 00:00, within one of the steps of 15 minutes, of which "
      "one begins at 00:07; day_start = 00:07 has days begin where a step does");
  EXPECT_EQ(fault(6, 3 * hour, "2014-02-28T00:00"), "none");
}

TEST(RainPeriods, law_7_a_single_odd_time_is_no_reason) {
  Steps steps = steps_from("2014-02-01T00:00", 24 * 20, hour);
  steps.insert(steps.begin() + 241, {"2014-02-11T00:30", {1}});
  steps.erase(steps.begin() + 240);
  EXPECT_EQ(fault_of(steps, days_from(0)), "none");
}

// Every value is a power of two or so, whose sums are exact.
TEST(RainPeriods, law_8_totals_add_up_to_the_values_whatever_the_periods) {
  Steps steps = steps_from("2015-11-20T00:00", 24 * 500, hour);
  double sum = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    steps[i].second[0] = i % 7 == 0 ? none : static_cast<double>(i % 29);
    if (i % 7 != 0) sum += steps[i].second[0];
  }
  for (const PeriodUnit unit : {PeriodUnit::hours, PeriodUnit::day, PeriodUnit::week,
                                PeriodUnit::month, PeriodUnit::season, PeriodUnit::year}) {
    for (const int hours : {1, 6, 24, 36}) {
      for (const Stamp stamp : {Stamp::begin, Stamp::end}) {
        Totalling totalling = days_from(9 * hour, unit);
        totalling.every.hours = hours;
        totalling.every.year_start = 10;
        totalling.allowed_missing = 100'000;
        totalling.stamp = stamp;
        double total = 0;
        for (const RainPeriod& period : periods_of(steps, totalling)) {
          if (!std::isnan(period.basins[0].rainfall)) total += period.basins[0].rainfall;
        }
        EXPECT_EQ(total, sum) << static_cast<int>(unit) << ' ' << hours;
      }
    }
  }
}

}  // namespace
}  // namespace thiessen

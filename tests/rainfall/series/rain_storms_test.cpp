#include "rainfall/series/rain_storms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"

namespace thiessen {
namespace {

using Steps = std::vector<std::pair<std::string, std::vector<double>>>;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Told {
  std::string storms;  ///< each as `time..last total/missing,...;`
  std::string warnings;
  std::string notices;
};

std::string text_of(double total) {
  return std::isnan(total) ? "-" : std::to_string(total).substr(0, 4);
}

Told storms_of(const Steps& steps, Totalling totalling) {
  Told told;
  RainStorms storms(totalling, "r.csv", [&](const RainPeriod& storm) {
    told.storms += storm.time + ".." + storm.last;
    for (const BasinTotal& total : storm.basins)
      told.storms += ' ' + text_of(total.rainfall) + '/' + std::to_string(total.missing);
    told.storms += ';';
  });
  for (const auto& [time, values] : steps) {
    RainStep step{time, {}, {}, {}};
    for (const double value : values) step.basins.push_back({value, 1, 1});
    storms.add(step);
  }
  Warnings warnings;
  storms.finish(warnings);
  for (const Message& message : warnings.messages()) told.warnings += message.sentence() + '\n';
  for (const Message& notice : warnings.notices()) told.notices += notice.sentence() + '\n';
  return told;
}

Totalling of_storms(std::int64_t dry_hours = 3) {
  Totalling totalling;
  totalling.every = PeriodUnit::storm;
  totalling.every.dry = 3'600 * dry_hours;
  totalling.step = StepLength{0, 3'600};
  return totalling;
}

std::string hour(int number) {
  const int day = 1 + number / 24;
  const int hour = number % 24;
  return "2020-05-" + std::string(day < 10 ? "0" : "") + std::to_string(day) + "T" +
         (hour < 10 ? "0" : "") + std::to_string(hour) + ":00";
}

/// Hourly steps of one basin from 2020-05-01T00:00; -1 is a step that the file lacks.
Steps hours(const std::vector<double>& values) {
  Steps steps;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] != -1) steps.push_back({hour(static_cast<int>(i)), {values[i]}});
  }
  return steps;
}

TEST(RainStorms, lie_between_dry_spells) {
  // Three dry hours part the first two, two do not part the second from what follows.
  const Told told = storms_of(hours({0, 0, 0, 1, 2, 0, 0, 0, 4, 0, 0, 8, 0, 0, 0}), of_storms());
  EXPECT_EQ(told.storms,
            "2020-05-01T03:00..2020-05-01T04:00 3.00/0;2020-05-01T08:00..2020-05-01T11:00 12.0/0;");
  EXPECT_EQ(told.warnings, "");
}

TEST(RainStorms, end_where_it_is_dry_in_every_basin) {
  EXPECT_EQ(storms_of({{hour(0), {0, 0}},
                       {hour(1), {0, 0}},
                       {hour(2), {0, 0}},
                       {hour(3), {1, 0}},
                       {hour(4), {0, 0}},
                       {hour(5), {0, 2}},
                       {hour(6), {0, 0}},
                       {hour(7), {0, 0}},
                       {hour(8), {0, 0}}},
                      of_storms())
                .storms,
            "2020-05-01T03:00..2020-05-01T05:00 1.00/0 2.00/0;");
}

TEST(RainStorms, law_1_what_lacks_in_one_or_so_near_that_rain_in_it_would_be_its_own_is_missing) {
  // Hour 4 lies in the storm of 3 to 5, hours 1 and 7 within three hours of it, and 0 and 9 do not.
  EXPECT_EQ(
      storms_of(hours({none, none, 0, 1, none, 2, 0, none, 0, none, 0, 0}), of_storms()).storms,
      "2020-05-01T03:00..2020-05-01T05:00 -/4;");
  Totalling allowed = of_storms();
  allowed.allowed_missing = 4;
  EXPECT_EQ(storms_of(hours({none, none, 0, 1, none, 2, 0, none, 0, none, 0, 0}), allowed).storms,
            "2020-05-01T03:00..2020-05-01T05:00 3.00/4;");
}

TEST(RainStorms, law_2_steps_that_the_file_lacks_are_missing_alike) {
  const Told told = storms_of(hours({0, -1, 0, 1, -1, 2, 0, -1, 0, -1, -1, 0, 0}), of_storms());
  EXPECT_EQ(told.storms, "2020-05-01T03:00..2020-05-01T05:00 -/3;");
  EXPECT_EQ(told.warnings,
            "r.csv: 2 steps that lie in no storm lack values: what fell in them is not told\n"
            "r.csv: a storm lacks steps of 1 hour: 2020-05-01T03:00, which lacks 3; they count as "
            "missing\n");
}

TEST(RainStorms, law_3_the_order_of_the_file_does_not_matter) {
  Steps steps = hours({none, none, 0, 1, none, 2, 0, none, 0, none, 0, 0, 0, 1, 1, 0, 0, 0});
  const std::string forth = storms_of(steps, of_storms()).storms;
  std::reverse(steps.begin(), steps.end());
  const std::string back = storms_of(steps, of_storms()).storms;
  const std::size_t first = forth.find(';') + 1;
  EXPECT_EQ(back, forth.substr(first) + forth.substr(0, first));
  EXPECT_EQ(forth.substr(first), "2020-05-01T13:00..2020-05-01T14:00 2.00/0;");
}

TEST(RainStorms, a_long_gap_parts_two_and_lacks_in_both) {
  std::vector<double> values(60, -1);
  values[0] = values[1] = values[2] = 0;
  values[3] = 1;
  values[50] = 2;
  std::fill(values.begin() + 51, values.end(), 0);
  // Of the 46 hours between, three are near either storm.
  const Told told = storms_of(hours(values), of_storms());
  EXPECT_EQ(told.storms,
            "2020-05-01T03:00..2020-05-01T03:00 -/3;2020-05-03T02:00..2020-05-03T02:00 -/3;");
  EXPECT_TRUE(told.warnings.starts_with("r.csv: 40 steps that lie in no storm lack values"))
      << told.warnings;
}

TEST(RainStorms, may_reach_beyond_the_file) {
  EXPECT_EQ(storms_of(hours({1, 0, 0, 0, 2}), of_storms()).notices,
            "r.csv: no dry spell comes before the first storm, nor after the last: the file may "
            "begin or end within one\n");
  Totalling whole = of_storms();
  whole.whole_alone = true;
  EXPECT_EQ(storms_of(hours({0, 0, 0, 1, 0, 0, 0, 2, 0, 0}), whole).storms,
            "2020-05-01T03:00..2020-05-01T03:00 1.00/0;");
  EXPECT_EQ(storms_of(hours({0, 0, 0, 1, 0, 0, 0}), whole).storms,
            "2020-05-01T03:00..2020-05-01T03:00 1.00/0;");
}

TEST(RainStorms, of_days_end_with_a_dry_day_where_spells_are_shorter) {
  Totalling days = of_storms(6);
  days.step = StepLength{0, 86'400};
  const Told told = storms_of({{"2020-02-27", {0}},
                               {"2020-02-28", {1}},
                               {"2020-02-29", {2}},
                               {"2020-03-01", {4}},
                               {"2020-03-02", {0}},
                               {"2020-03-03", {8}},
                               {"2020-03-04", {0}}},
                              days);
  EXPECT_EQ(told.storms, "2020-02-28..2020-03-01 7.00/0;2020-03-03..2020-03-03 8.00/0;");
  EXPECT_EQ(told.notices,
            "r.csv: steps of 1 day are longer than the dry spell that ends a storm, 6 hours: every "
            "dry step ends one\n");
}

TEST(RainStorms, learn_the_step_from_times_that_come) {
  Totalling fed = of_storms();
  fed.step.reset();
  EXPECT_EQ(storms_of(hours({0, 0, 0, 1, 2, 0, 0, 0, 4, 0, 0, 8, 0, 0, 0}), fed).storms,
            "2020-05-01T03:00..2020-05-01T04:00 3.00/0;2020-05-01T08:00..2020-05-01T11:00 12.0/0;");
}

TEST(RainStorms, refuse_times_that_turn_back_and_months) {
  const auto fault = [](const Steps& steps, const Totalling& totalling) {
    try {
      storms_of(steps, totalling);
    } catch (const Error& error) {
      return error.messages().at(0).sentence();
    }
    return std::string("none");
  };
  EXPECT_EQ(fault({{hour(0), {1}}, {hour(2), {1}}, {hour(1), {1}}}, of_storms()),
            "r.csv: time '2020-05-01T01:00' turns back, and storms want times in their order");
  EXPECT_EQ(fault({{hour(0), {1}}, {"2020-05-01 00:00", {1}}}, of_storms()),
            "r.csv: time '2020-05-01 00:00' is that of the step before, written again");
  Totalling months = of_storms();
  months.step = StepLength{1, 0};
  EXPECT_EQ(fault({{"2020-05-01", {1}}}, months),
            "r.csv: the steps are of 1 month, and storms lie between dry spells of hours");
}

}  // namespace
}  // namespace thiessen

#include "readings/steps/mixed_steps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
using Steps = std::vector<std::pair<std::string, std::vector<double>>>;

std::string fault_of(const Steps& steps) {
  const std::vector<Station> stations{{"A", {}}, {"B", {}}};
  MixedSteps mixed(stations.size());
  std::size_t line = 1;
  for (const auto& [time, readings] : steps) mixed.note(time, ++line, readings);
  const auto fault = mixed.fault("r.csv", stations);
  return fault ? fault->sentence() : "none";
}

std::string hour(int day, int hour) {
  return (day < 10 ? "2020-01-0" : "2020-01-") + std::to_string(day) + (hour < 10 ? "T0" : "T") +
         std::to_string(hour) + ":00";
}

TEST(MixedSteps, law_1_AGaugeThatFillsEveryKthStepIsOfLongerSteps) {
  Steps steps;
  for (int day = 1; day <= 3; ++day) {
    for (int h = 0; h < 24; ++h) steps.push_back({hour(day, h), {1, h == 7 ? 24 : silent}});
  }
  EXPECT_EQ(fault_of(steps),
            "r.csv: station 'B' reports every 1 day in a file whose step is 1 hour: steps of two "
            "lengths in one table");
  steps[31].second[1] = silent;  // of three readings two are left
  EXPECT_EQ(fault_of(steps), "none");
}

TEST(MixedSteps, law_2_AGaugeThatReportsInTwoStepsOnEndIsOfTheFilesSteps) {
  Steps steps;
  for (int day = 1; day <= 3; ++day) {
    for (int h = 0; h < 24; ++h)
      steps.push_back({hour(day, h), {1, h == 7 || (day == 2 && h == 8) ? 24 : silent}});
  }
  EXPECT_EQ(fault_of(steps), "none");
}

TEST(MixedSteps, law_3_AGaugeThatIsSilentMostOfTheTimeTellsNothing) {
  Steps steps;
  for (int day = 1; day <= 31; ++day)
    steps.push_back({hour(day, 0), {1, day == 1 || day == 13 || day == 31 ? 1 : silent}});
  EXPECT_EQ(fault_of(steps), "none");  // multiples of 6 days, but 3 of 6 places
  steps[12].second[1] = silent;
  steps[14].second[1] = 1;  // every 2 days, 3 of 16 places
  EXPECT_EQ(fault_of(steps), "none");
}

TEST(MixedSteps, are_found_among_months) {
  Steps steps;
  for (const char* month : {"01", "02", "03", "04", "05", "06", "07", "08", "09"}) {
    const bool quarter =
        std::string(month) == "03" || std::string(month) == "06" || std::string(month) == "09";
    steps.push_back({std::string("2020-") + month, {1, quarter ? 3 : silent}});
  }
  EXPECT_EQ(fault_of(steps),
            "r.csv: station 'B' reports every 3 months in a file whose step is 1 month: steps of "
            "two lengths in one table");
}

TEST(MixedSteps, are_found_where_the_first_two_times_are_a_month_apart) {
  Steps steps{{"2020-01-01", {1, 1}}};
  for (int day = 2; day <= 9; ++day)
    steps.push_back({"2020-01-0" + std::to_string(day), {1, day % 2 == 1 ? 1 : silent}});
  EXPECT_EQ(fault_of(steps),
            "r.csv: station 'B' reports every 2 days in a file whose step is 1 day: steps of two "
            "lengths in one table");
}

TEST(MixedSteps, are_times_with_a_clock_beside_times_without_one) {
  EXPECT_EQ(fault_of({{"2020-01-01 00:00", {1, silent}},
                      {"2020-01-01 01:00", {2, silent}},
                      {"2020-01-01", {silent, 9}}}),
            "r.csv: station 'B' reports at times without a clock, such as '2020-01-01', beside "
            "times with one, such as '2020-01-01 00:00': steps of two lengths in one table");
}

TEST(MixedSteps, are_months_beside_days) {
  EXPECT_EQ(
      fault_of(
          {{"2020-01-01", {1, silent}}, {"2020-01-02", {1, silent}}, {"2020-01", {silent, 9}}}),
      "r.csv: station 'B' reports at times without a day, such as '2020-01', beside times "
      "with one, such as '2020-01-01': steps of two lengths in one table");
  Steps steps;
  for (int month = 1; month <= 3; ++month) {
    for (int day = 1; day <= 29; ++day) {
      steps.push_back(
          {"2020-0" + std::to_string(month) + (day < 10 ? "-0" : "-") + std::to_string(day),
           {1, day == 1 ? 31 : silent}});
    }
  }
  EXPECT_EQ(fault_of(steps),
            "r.csv: station 'B' reports every 1 month in a file whose step is 1 day: steps of two "
            "lengths in one table");
  steps[40].second[1] = 2;  // twice in February
  EXPECT_EQ(fault_of(steps), "none");
}

TEST(MixedSteps, law_4_GaugesThatAreSilentAtRandomAreNotTakenForCoarseOnes) {
  constexpr std::size_t gauges = 100;
  std::mt19937_64 random(1);
  std::bernoulli_distribution is_silent(0.3);
  const std::vector<Station> stations(gauges, Station{"A", {}});
  for (int round = 0; round < 50; ++round) {
    MixedSteps mixed(gauges);
    const int steps = 6 + round % 7;
    for (int h = 0; h < steps; ++h) {
      std::vector<double> readings(gauges, 1);
      for (double& reading : readings) reading = is_silent(random) ? silent : 1;
      mixed.note(hour(1, h), 2, readings);
    }
    EXPECT_FALSE(mixed.fault("r.csv", stations)) << "round " << round;
  }
}

TEST(MixedSteps, are_not_sought_among_labels) {
  EXPECT_EQ(fault_of({{"storm", {1, 2}}, {"2020-01-01", {1, 2}}, {"2020-01-01T01:00", {1, 2}}}),
            "none");
}

TEST(MixedSteps, zones_are_written_everywhere_or_nowhere) {
  EXPECT_EQ(fault_of({{"2020-01-01T00:00Z", {1, 1}}, {"2020-01-01T01:00", {1, 1}}}),
            "r.csv:3: time '2020-01-01T01:00' has no zone, and '2020-01-01T00:00Z' in line 2 has "
            "one");
  EXPECT_EQ(fault_of({{"2020-01-01T00:00Z", {1, 1}}, {"2020-01-01T01:00+01:00", {1, 1}}}), "none");
}

}  // namespace
}  // namespace thiessen

#include "rainfall/series/gauge_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// P and Q stand at one place, R and S at places of their own.
const Network& network() {
  static const Network of_four({{"P", {2, 5}}, {"Q", {2, 5}}, {"R", {8, 5}}, {"S", {8, 8}}},
                               Metric::planar);
  return of_four;
}

class Steps : public Readings {
 public:
  explicit Steps(std::vector<std::vector<double>> steps) : steps_(std::move(steps)) {}
  bool next(TimeStep& step) override {
    if (given_ == steps_.size()) return false;
    step.time = std::to_string(given_ + 1);
    step.readings = steps_[given_++];
    return true;
  }

 private:
  std::vector<std::vector<double>> steps_;
  std::size_t given_ = 0;
};

Steps steps() {
  return Steps({{10, 30, 0, silent}, {silent, 30, 0, silent}, {silent, silent, 6, silent}});
}

void expect_readings(const GaugeReadings& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.readings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(std::isnan(found.readings[i]), std::isnan(expected[i])) << i;
    if (std::isnan(expected[i])) continue;
    EXPECT_EQ(found.readings[i], expected[i]) << i;
  }
}

TEST(GaugeReadings, at_a_time_are_the_means_of_those_at_a_place_that_report) {
  Steps all = steps();
  const GaugeReadings first = read_gauges(all, network(), "1");
  expect_readings(first, {20, 20, 0, silent});
  EXPECT_EQ(first.label, "1");
  Steps again = steps();
  expect_readings(read_gauges(again, network(), "2"), {silent, 30, 0, silent});
}

// The place has 20, then 30, and nothing: its mean is 25, though P's own would be 10 and Q's 30.
TEST(GaugeReadings, over_time_are_the_means_of_the_place_s_own_values) {
  Steps all = steps();
  const GaugeReadings means = read_gauges(all, network(), "");
  expect_readings(means, {25, 25, 2, silent});
  EXPECT_EQ(means.label, "each gauge's mean over the steps it reports, of 3 time steps");
  EXPECT_EQ(means.reports(), (ReportingStations{true, true, true, false}));
}

TEST(GaugeReadings, of_a_whole_network_are_those_of_the_places) {
  MeanReadings means(network());
  means.add(std::vector<double>{silent, 30, 0, silent});
  expect_readings(means.of_reporting(), {silent, 30, 0, silent});
  expect_readings(means.of_all(), {30, 30, 0, silent});
}

TEST(GaugeReadings, of_a_time_that_is_not_there_are_none) {
  Steps all = steps();
  EXPECT_TRUE(read_gauges(all, network(), "4").readings.empty());
}

TEST(GaugeReadings, of_several_times_come_in_their_order) {
  Steps all = steps();
  const std::vector<std::string> times = {"3", "9", "1"};
  const std::vector<GaugeReadings> found = read_steps(all, network(), times);
  ASSERT_EQ(found.size(), 3U);
  expect_readings(found[0], {silent, silent, 6, silent});
  EXPECT_EQ(found[0].label, "3");
  EXPECT_TRUE(found[1].readings.empty()) << "the table lacks it";
  expect_readings(found[2], {20, 20, 0, silent});
}

// A day's rain is of a day, whichever time is shown; one time alone tells no step.
TEST(GaugeReadings, know_the_length_of_a_step_by_the_times) {
  MeanReadings means(network());
  for (const char* time : {"2020-01-01", "2020-01-02"}) {
    EXPECT_EQ(means.step(), std::nullopt);
    means.note(time, parse_iso_time(time));
  }
  EXPECT_EQ(means.step(), (StepLength{0, 86'400}));
  EXPECT_EQ(means.of_all().step, means.step());
}

TEST(GaugeReadings, of_one_step_are_called_as_it_is) {
  MeanReadings means(network());
  const std::vector<double> readings{1, 2, 3, 4};
  means.note("storm", {});
  means.add(readings);
  EXPECT_EQ(means.of_all().label, "storm");
  means.note("next", {});
  means.add(readings);
  EXPECT_EQ(means.of_all().label, "each gauge's mean over the steps it reports, of 2 time steps");
}

}  // namespace
}  // namespace thiessen

#include "rainfall/series/largest_depths.h"

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
constexpr std::int64_t hour = 3'600;

/// The largest depths of the first basin, as `depth at time;`, or what is wrong.
std::string depths_of(const Steps& steps, std::vector<std::int64_t> lengths,
                      const std::optional<StepLength>& rate = {}) {
  try {
    LargestDepths depths(std::move(lengths), steps.empty() ? 1 : steps[0].second.size(), "r.csv");
    for (const auto& [time, values] : steps) {
      RainStep step{time, {}, {}, {}};
      for (const double value : values) step.basins.push_back({value, 1, 1});
      depths.add(step);
    }
    std::string text;
    for (const auto& of_length : depths.result(rate)) {
      const auto& largest = of_length.at(0);
      text += largest ? std::to_string(largest->depth).substr(0, 4) + " at " + largest->time : "-";
      text += ';';
    }
    return text;
  } catch (const Error& error) {
    return error.messages().at(0).sentence() + "; " + error.messages().at(0).hint.plain();
  }
}

const Steps day = {{"2020-05-01T00:00", {1}}, {"2020-05-01T01:00", {5}}, {"2020-05-01T02:00", {0}},
                   {"2020-05-01T03:00", {4}}, {"2020-05-01T04:00", {3}}, {"2020-05-01T05:00", {5}}};

// Two hours: 4 + 3 = 7 from 3, 3 + 5 = 8 from 4; three: 4 + 3 + 5 = 12; four: 0 + 12, and 1 to 4
// too.
TEST(LargestDepths, are_of_the_steps_that_follow_each_other) {
  EXPECT_EQ(depths_of(day, {hour, 2 * hour, 3 * hour, 4 * hour, 7 * hour}),
            "5.00 at 2020-05-01T01:00;8.00 at 2020-05-01T04:00;12.0 at 2020-05-01T03:00;"
            "12.0 at 2020-05-01T01:00;-;");
}

TEST(LargestDepths, law_1_the_order_of_the_file_does_not_matter) {
  Steps back = day;
  std::reverse(back.begin(), back.end());
  const std::vector<std::int64_t> lengths{hour, 2 * hour, 4 * hour};
  EXPECT_EQ(depths_of(back, lengths), depths_of(day, lengths));
}

TEST(LargestDepths, law_2_no_step_of_them_lacks) {
  Steps lacking = day;
  lacking[4].second[0] = none;
  EXPECT_EQ(depths_of(lacking, {2 * hour, 4 * hour}),
            "6.00 at 2020-05-01T00:00;10.0 at 2020-05-01T00:00;");
  lacking.erase(lacking.begin() + 4);
  EXPECT_EQ(depths_of(lacking, {2 * hour, 3 * hour}),
            "6.00 at 2020-05-01T00:00;9.00 at 2020-05-01T01:00;");
}

TEST(LargestDepths, law_3_sums_are_those_of_each_window_alone) {
  Steps steps;
  std::vector<double> values;
  std::uint64_t state = 20'260'101;
  for (int i = 0; i < 5'000; ++i) {
    state = state * 6'364'136'223'846'793'005u + 1'442'695'040'888'963'407u;
    values.push_back((state >> 33) % 5 == 0 ? static_cast<double>((state >> 40) % 1'000) / 10 : 0);
    steps.push_back({time_text(hour * i, TimePrecision::instant), {values.back()}});
  }
  double largest = 0;
  for (std::size_t i = 0; i + 24 <= values.size(); ++i) {
    double sum = 0;
    for (std::size_t k = i; k < i + 24; ++k) sum += values[k];
    largest = std::max(largest, sum);
  }
  LargestDepths depths({24 * hour}, 1, "r.csv");
  for (const auto& [time, value] : steps) depths.add({time, {}, {{value[0], 1, 1}}, {}});
  EXPECT_NEAR(depths.result({}).at(0).at(0)->depth, largest, 1e-9);
}

TEST(LargestDepths, know_the_step_in_the_end_alone) {
  // The file begins with a gap of three hours, which is no step of it.
  Steps steps = day;
  steps.insert(steps.begin(), {"2020-04-30T21:00", {9}});
  for (int i = 6; i < 20; ++i)
    steps.push_back({time_text(1'588'291'200 + hour * i, TimePrecision::instant), {0}});
  EXPECT_EQ(depths_of(steps, {hour, 3 * hour}),
            "9.00 at 2020-04-30T21:00;12.0 at 2020-05-01T03:00;");
}

TEST(LargestDepths, of_rates_are_what_falls) {
  EXPECT_EQ(
      depths_of({{"2020-05-01T00:00", {4}}, {"2020-05-01T00:15", {8}}, {"2020-05-01T00:30", {2}}},
                {1'800}, StepLength{0, hour}),
      "3.00 at 2020-05-01T00:00;");
}

TEST(LargestDepths, want_whole_steps) {
  EXPECT_EQ(depths_of({{"2020-05-01", {4}}, {"2020-05-02", {8}}}, {hour}),
            "r.csv: 1h are no whole steps of the file, which are of 1 day; max = 24h is");
  EXPECT_EQ(depths_of({{"2020-05", {4}}, {"2020-06", {8}}}, {hour}),
            "r.csv: 1h are no whole steps of the file, which are of 1 month; leave 'max' out");
  EXPECT_EQ(depths_of({{"2020-05-01", {4}}}, {24 * hour}),
            "r.csv: the largest depths want a step, and one time tells none; leave 'max' out");
  EXPECT_EQ(
      depths_of({{"2020-05-01", {4}}, {"2020-05-03", {4}}, {"2020-05-02", {8}}}, {24 * hour}),
      "r.csv: time '2020-05-02' turns back, and the largest depths want times in their order; "
      "sort the file by time");
}

}  // namespace
}  // namespace thiessen

#include "cli/summary/summary.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

RainStep step(double a, double b, double rainfall) {
  RainStep step;
  step.readings = {a, b};
  step.basins = {{rainfall, 2, 1}};
  return step;
}

// The weights are 0.4 and 0.6. Without B the means of 16 and 18 become 10 and 30, and without A 20
// and 10: root mean squares of 9.49 and 6.32.
TEST(Summary, tells_of_each_basin_what_the_series_comes_to) {
  const GivenInputs given;
  const ArealRainfall rainfall(given.inputs.weighing(), {}, 1);
  Summary summary(given.inputs, rainfall.full_weights());
  summary.add(step(10, 20, 16));
  summary.add(step(30, 10, 18));
  summary.add(step(silent, silent, silent));
  summary.set_errors_of_mean({0.5}, "");
  summary.find_most_influential(rainfall, 1);
  const BasinSummary found = summary.basins().at(0);
  EXPECT_EQ(found.basin, "Q");
  EXPECT_DOUBLE_EQ(found.area, 40);
  EXPECT_EQ(found.gauges_inside, 2U);
  EXPECT_EQ(found.gauges_weighing, 2U);
  EXPECT_NEAR(found.largest_weight, 0.6, 1e-12);
  EXPECT_EQ(found.mean, 17);
  EXPECT_EQ(found.standard_error, 0.5);
  EXPECT_EQ(found.largest, 18);
  EXPECT_EQ(found.empty_steps, 1U);
  EXPECT_EQ(found.most_influential, "B");
  EXPECT_NEAR(found.influence, 9.4868, 1e-4);
  EXPECT_EQ(summary.text("mm", 80),
            "              gauges                   std.                  most\n"
            "              inside  largest   mean  error  largest  empty  influential  moves\n"
            "basin   area  / used   weight     mm     mm       mm  steps  gauge        it mm\n"
            "Q      40.00   2 / 2    0.600  17.00   0.50    18.00      1  B              9.5\n");
}

TEST(Summary, leaves_out_what_there_is_none_of) {
  const GivenInputs given;
  const ArealRainfall rainfall(given.inputs.weighing(), {}, 1);
  Summary summary(given.inputs, rainfall.full_weights());
  summary.add(step(silent, silent, silent));
  summary.set_errors_of_mean({silent}, "no two gauges report");
  summary.find_most_influential(rainfall, 1);
  const BasinSummary found = summary.basins().at(0);
  EXPECT_FALSE(found.mean || found.standard_error || found.largest);
  EXPECT_EQ(found.most_influential, "");
  EXPECT_TRUE(summary.text("", 80).ends_with("No standard errors: no two gauges report.\n"));
}

TEST(Summary, says_why_no_gauge_is_the_most_influential) {
  const GivenInputs given;
  const ArealRainfall rainfall(given.inputs.weighing(), {}, 1);
  Summary summary(given.inputs, rainfall.full_weights());
  EXPECT_EQ(summary.text("", 80).find("--gaps"), std::string::npos)
      << "without a step there is none";
  summary.add(step(1, 1, 1));
  EXPECT_TRUE(
      summary.text("", 80).ends_with("The most influential gauges are told with --gaps "
                                     "retessellate and without\n--min-gauges.\n"));
}

// It looks at 4,096 steps at most.
TEST(Summary, says_in_how_many_steps_it_looked_for_the_most_influential_gauge) {
  const GivenInputs given;
  const ArealRainfall rainfall(given.inputs.weighing(), {}, 1);
  Summary summary(given.inputs, rainfall.full_weights());
  for (int i = 0; i < 5000; ++i) summary.add(step(10, 20, 16));
  summary.find_most_influential(rainfall, 1);
  const std::string told = summary.remarks();
  EXPECT_NE(told.find("The most influential gauges are those of "), std::string::npos) << told;
  EXPECT_NE(told.find(" of the 5000 steps, evenly spaced"), std::string::npos) << told;
  const std::string text = summary.text("mm", 80);
  EXPECT_NE(text.find("6.0\n"), std::string::npos) << text;
  EXPECT_NE(text.find("spaced:\nlooking for them may take"), std::string::npos) << text;
}

TEST(Summary, has_square_kilometres_where_the_unit_is_known) {
  const GivenInputs given(files_in_utm());
  const ArealRainfall rainfall(given.inputs.weighing(), {}, 1);
  const std::string text = Summary(given.inputs, rainfall.full_weights()).text("", 80);
  EXPECT_NE(text.find("km2"), std::string::npos) << text;
  EXPECT_NE(text.find(" 4.000 "), std::string::npos) << text;
}

}  // namespace
}  // namespace thiessen::cli

// Which steps a series has given before.
#include "readings/steps/given_steps.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace thiessen {
namespace {

using Came = GivenSteps::Came;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Came take(GivenSteps& given, const std::string& time, const std::vector<double>& readings) {
  TimeStep step;
  step.time = time;
  step.readings = readings;
  return given.take(step);
}

TEST(GivenSteps, are_told_by_their_moment_in_whatever_order) {
  GivenSteps given;
  EXPECT_EQ(take(given, "2020-01-02", {1, none}), Came::first);
  EXPECT_EQ(take(given, "2020-01-04", {1, 2}), Came::first);
  EXPECT_EQ(take(given, "2020-01-03", {1, 2}), Came::first);
  EXPECT_EQ(take(given, "20200102", {1, none}), Came::again);
  EXPECT_EQ(take(given, "2020-01-03", {1, 2}), Came::again);
  EXPECT_EQ(take(given, "2020-01-04", {1, 2}), Came::again);
  EXPECT_EQ(take(given, "2020-01-01", {1, 2}), Came::first);
  EXPECT_EQ(take(given, "2020-01-01T00:00:00.5", {1, 2}), Came::first);
  EXPECT_EQ(take(given, "2020-01-05", {1, 2}), Came::first);
}

TEST(GivenSteps, tell_other_readings_from_the_same) {
  GivenSteps given;
  take(given, "2020-01-02", {1, none});
  take(given, "step 1", {1, none});
  EXPECT_EQ(take(given, "2020-01-02", {none, 1}), Came::again_otherwise);
  EXPECT_EQ(take(given, "2020-01-02", {1, 0}), Came::again_otherwise);
  EXPECT_EQ(take(given, "step 1", {1, 2}), Came::again_otherwise);
  EXPECT_EQ(take(given, "2020-01-02", {1, none}), Came::again) << "what came first stays";
  EXPECT_EQ(take(given, "step 1", {1, none}), Came::again);
}

}  // namespace
}  // namespace thiessen

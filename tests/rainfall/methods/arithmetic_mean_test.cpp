#include "rainfall/methods/arithmetic_mean.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

TEST(ArithmeticMean, is_of_the_gauges_inside) {
  const Study study = textbook_study();
  // Gauges 2, 5, 7, 9 and, on the edge, 3.
  auto value = rainfall_of(study, arithmetic, textbook::readings(), Gaps::retessellate)[0];
  EXPECT_DOUBLE_EQ(value.rainfall, (59 + 41 + 105 + 60 + 81) / 5.0);
  EXPECT_EQ(value.gauges, 5u);
  EXPECT_EQ(value.coverage, 1);
  std::vector<double> readings = textbook::readings();
  readings[1] = silent;
  value = rainfall_of(study, arithmetic, readings, Gaps::retessellate)[0];
  EXPECT_DOUBLE_EQ(value.rainfall, (41 + 105 + 60 + 81) / 4.0);
  EXPECT_DOUBLE_EQ(value.coverage, 0.8);
  EXPECT_DOUBLE_EQ(rainfall_of(study, arithmetic, readings, Gaps::renormalise)[0].rainfall,
                   (41 + 105 + 60 + 81) / 4.0);
  EXPECT_TRUE(std::isnan(rainfall_of(study, arithmetic, readings, Gaps::strict)[0].rainfall));
  EXPECT_TRUE(
      std::isnan(rainfall_of(study, arithmetic, readings, Gaps::retessellate, 5)[0].rainfall));
  for (const std::size_t i : {2u, 4u, 6u, 8u}) readings[i] = silent;
  value = rainfall_of(study, arithmetic, readings, Gaps::retessellate)[0];
  EXPECT_TRUE(std::isnan(value.rainfall));
  EXPECT_EQ(value.gauges, 0u);
}

TEST(ArithmeticMean, over_the_antimeridian_and_at_shared_places) {
  const Basin basin = shapes::basin({{shapes::rectangle({175, -5}, {185, 5}), {}}});
  const Study study({{"a", {179, 0}}, {"b", {-179, 1}}, {"c", {-179, 1}}, {"d", {170, 0}}}, {basin},
                    earth);
  EXPECT_DOUBLE_EQ(rainfall_of(study, arithmetic, {1, 3, 5, 100}, Gaps::retessellate)[0].rainfall,
                   2.5);
  const auto value = rainfall_of(study, arithmetic, {1, silent, 5, 100}, Gaps::retessellate)[0];
  EXPECT_DOUBLE_EQ(value.rainfall, 3);
  EXPECT_EQ(value.gauges, 2u);
  EXPECT_DOUBLE_EQ(value.coverage, 0.75);
  EXPECT_DOUBLE_EQ(
      rainfall_of(study, arithmetic, {1, silent, 5, 100}, Gaps::renormalise)[0].rainfall,
      (0.5 * 1 + 0.25 * 5) / 0.75);
}

}  // namespace
}  // namespace thiessen

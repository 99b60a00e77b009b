#include "rainfall/methods/isohyetal_rainfall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

IsohyetalRainfall rainfall_by_isohyets(const Study& study, double interval,
                                       std::size_t points = 2000) {
  return {study.weighing,
          std::make_unique<const MethodRainfall>(study.weighing, natural(study.weighing),
                                                 ArealRainfallSettings{}),
          points, interval, 1};
}

/// Gauges round about, and the basins.
Study within_four_gauges(std::vector<Basin> basins) {
  return {{{"a", {-10, -10}}, {"b", {14, -10}}, {"c", {14, 14}}, {"d", {-10, 14}}},
          std::move(basins),
          plane};
}

/// Their readings, of which natural neighbours make the plane x.
const std::vector<double> slope{-10, 14, 14, -10};

// A triangle that is as wide as far from its corner: its isohyet 2 parts 8 into 2 and 6, of which
// the mid-levels are 1 and 3. By the surface itself its mean is 8 / 3.
TEST(IsohyetalRainfall, is_areas_between_isohyets_times_their_mid_levels) {
  const Study study = within_four_gauges({shapes::basin({{{{0, 0}, {4, 0}, {4, 4}}, {}}})});
  const double by_hand = (2 * 1 + 6 * 3) / 8.0;
  EXPECT_NEAR(rainfall_by_isohyets(study, 2).at(slope).at(0).rainfall, by_hand, 2e-2);
  EXPECT_NEAR(rainfall_by_isohyets(study, 0.05).at(slope).at(0).rainfall, 8.0 / 3, 1e-2)
      << "ever closer isohyets tell the surface's own mean";
}

// Even where so few points stand for the basin that none is near its corners.
TEST(IsohyetalRainfall, reaches_from_the_least_to_the_largest_value_at_the_outline) {
  const Study study = within_four_gauges({shapes::basin({{{{0, 0}, {4, 0}, {4, 4}}, {}}})});
  EXPECT_NEAR(rainfall_by_isohyets(study, 1000, 10).at(slope).at(0).rainfall, 2, 1e-12)
      << "without an isohyet in between it is the mean of both";
}

// The gauges lie alike round the peak, so that the least values are those of the corners.
TEST(IsohyetalRainfall, looks_at_the_outlines_of_holes_too) {
  const Study study(
      {{"a", {-10, -10}}, {"b", {14, -10}}, {"c", {14, 14}}, {"d", {-10, 14}}, {"peak", {2, 2}}},
      {shapes::basin({{shapes::rectangle({0, 0}, {4, 4}), {{{2, 2}, {2, 3}, {3, 2}}}}})}, plane);
  const std::vector<double> readings{0, 0, 0, 0, 100};
  const auto surface = surface_of(SurfaceMethod::natural, study.network, Metric::planar, readings);
  const double least = surface->at({0, 0}).rainfall;
  EXPECT_NEAR(rainfall_by_isohyets(study, 1000, 10).at(readings).at(0).rainfall, (least + 100) / 2,
              1e-9);
}

TEST(IsohyetalRainfall, law_1_of_equal_readings_is_their_value) {
  const Study study = textbook_study();
  for (const double interval : {0.0, 0.5, 1000.0}) {
    const std::vector<double> readings(9, 12.5);
    EXPECT_NEAR(rainfall_by_isohyets(study, interval).at(readings).at(0).rainfall, 12.5, 1e-12);
  }
}

TEST(IsohyetalRainfall, law_2_lies_between_the_readings) {
  const Study study = textbook_study();
  const auto readings = textbook::readings();
  for (const double interval : {0.0, 1.0, 10.0, 50.0}) {
    const double value = rainfall_by_isohyets(study, interval).at(readings).at(0).rainfall;
    EXPECT_GT(value, 39);
    EXPECT_LT(value, 105);
  }
}

TEST(IsohyetalRainfall, law_3_has_the_gauges_the_coverage_and_the_weights_of_natural_neighbours) {
  const Study study = textbook_study();
  const MethodRainfall by_natural(study.weighing, natural(study.weighing), {});
  const IsohyetalRainfall by_isohyets = rainfall_by_isohyets(study, 10, 300);
  auto readings = textbook::readings();
  readings[4] = silent;
  const auto wanted = by_natural.at(readings).at(0);
  const auto found = by_isohyets.at(readings).at(0);
  EXPECT_EQ(found.gauges, wanted.gauges);
  EXPECT_EQ(found.coverage, wanted.coverage);
  EXPECT_LT(found.coverage, 1);
  EXPECT_NEAR(found.rainfall, wanted.rainfall, 3) << "both are means of one surface";
  const auto weights = by_isohyets.weights_at(readings).at(0).stations;
  const auto natural_weights = by_natural.weights_at(readings).at(0).stations;
  ASSERT_EQ(weights.size(), natural_weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_EQ(weights[i].station, natural_weights[i].station);
    EXPECT_EQ(weights[i].weight, natural_weights[i].weight);
  }
}

TEST(IsohyetalRainfall, is_nothing_where_no_gauge_reports) {
  const Study study = textbook_study();
  const auto value = rainfall_by_isohyets(study, 10, 50).at(std::vector<double>(9, silent)).at(0);
  EXPECT_TRUE(std::isnan(value.rainfall));
  EXPECT_EQ(value.gauges, 0U);
}

}  // namespace
}  // namespace thiessen

#include "rainfall/errors/mean_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/errors/lasting_series.h"
#include "rainfall/errors/rainfall_error.h"
#include "rainfall/normals/doubtful_normals.h"

namespace thiessen {
namespace {

constexpr Yardstick plane{Metric::planar, 1, 0.1};

// Law: where fields come in pairs of opposites about one that lasts, the mean is off as that one
// is.
TEST(MeanError, of_what_cancels_in_pairs_is_that_of_what_lasts) {
  Seeded seeded;
  const LastingSeries series(seeded, {"", 0, 0, 31});
  const std::vector<Basin> basins = quarters();
  const Network network(series.stations(), Metric::planar);
  const Weighing weighing(network, basins, plane);
  const ArealRainfall rainfall(weighing, {}, 1);
  MeanError error(rainfall, weighing);
  StepSample sample(40, 100);
  const std::vector<double>& lasting = series.steps()[0];
  for (std::size_t t = 1; t <= 30; ++t) {
    for (const double sign : {1.0, -1.0}) {
      std::vector<double> readings = lasting;
      for (std::size_t g = 0; g < readings.size(); ++g) readings[g] += sign * series.steps()[t][g];
      error.add(readings);
      sample.add(readings);
    }
  }
  const std::vector<double> of_mean = error.result(1);
  const auto of_step = RainfallError(rainfall, weighing, sample, 1).at(lasting);
  // Six near gauges tell the one variance, three the other: the same for all basins.
  const double ratio = of_mean[0] / of_step[0].standard_error;
  EXPECT_NEAR(ratio, 1, 0.25);
  for (std::size_t b = 0; b < 4; ++b)
    EXPECT_NEAR(of_mean[b] / of_step[b].standard_error, ratio, 1e-9);
}

/// The mean's errors where readings are lifted by normals of the gauges, by a part of which the
/// basins' normals are wrong.
std::vector<double> errors_with_normals(const LastingSeries& series,
                                        const std::vector<double>& of_gauges,
                                        const std::vector<double>& of_basins, double log_variance) {
  const std::vector<Basin> basins = quarters();
  const Network network(series.stations(), Metric::planar);
  Weighing weighing(network, basins, plane);
  weighing.take_normals(
      std::make_shared<const DoubtfulNormals>(of_gauges, of_basins, log_variance));
  const ArealRainfall rainfall(weighing, {}, 1);
  MeanError error(rainfall, weighing);
  for (const auto& readings : series.steps()) {
    std::vector<double> lifted = readings;
    for (std::size_t g = 0; g < lifted.size(); ++g) lifted[g] *= of_gauges[g] / of_gauges[0];
    // The mean of the values is 8 whatever the readings: what normals err is a share of it.
    error.add(lifted, std::vector<BasinRainfall>(4, {8, 0, 0}), {});
  }
  return error.result(1);
}

// Law: the error of the field below counts times the basin's normal, and that of the normal is
// added as a share of the mean value.
TEST(MeanError, with_normals_is_of_the_field_below_and_of_the_normals) {
  Seeded seeded;
  const LastingSeries series(seeded, {"", 0.5, 0.1, 30});
  std::vector<double> of_gauges;
  for (int g = 0; g < 40; ++g) of_gauges.push_back(seeded.uniform(10, 40));
  const auto flat = errors_with_normals(series, std::vector<double>(40, 1), {1, 1, 1, 1}, 0);
  const std::vector<double> of_basins{30, 10, 20, 40};
  const auto lifted = errors_with_normals(series, of_gauges, of_basins, 0.01);
  for (std::size_t b = 0; b < 4; ++b) {
    const double of_field = flat[b] * of_basins[b] / of_gauges[0];
    EXPECT_NEAR(lifted[b] / std::hypot(of_field, 0.1 * 8), 1, 1e-6);
  }
}

// All means of what is divided by normals are the same where these are the gauges' own means: then
// the normals' error is all there is.
TEST(MeanError, with_normals_that_leave_nothing_is_that_of_the_normals) {
  Seeded seeded;
  const LastingSeries series(seeded, {"", 0, 0, 30});
  const std::vector<Basin> basins = quarters();
  const Network network(series.stations(), Metric::planar);
  Weighing weighing(network, basins, plane);
  weighing.take_normals(std::make_shared<const DoubtfulNormals>(std::vector<double>(40, 1),
                                                                std::vector<double>(4, 1), 0.04));
  const ArealRainfall rainfall(weighing, {}, 1);
  MeanError error(rainfall, weighing);
  // Each step is followed by its opposite, in sixteenths, so that sums are exact.
  for (const auto& readings : series.steps()) {
    for (const double sign : {1.0, -1.0}) {
      std::vector<double> pair = readings;
      for (double& r : pair) r = 20 + sign * std::round(16 * (r - 20)) / 16;
      error.add(pair, std::vector<BasinRainfall>(4, {20, 0, 0}), {});
    }
  }
  for (const double e : error.result(1)) EXPECT_NEAR(e, 0.2 * 20, 1e-12);
  EXPECT_EQ(error.shortfall(), "");
}

TEST(MeanError, is_none_where_there_is_too_little) {
  Seeded seeded;
  const LastingSeries series(seeded, {"", 0, 0, 5});
  const std::vector<Basin> basins = quarters();
  const Network network(series.stations(), Metric::planar);
  const Weighing weighing(network, basins, plane);
  const ArealRainfall rainfall(weighing, {}, 1);
  MeanError error(rainfall, weighing);
  for (const auto& readings : series.steps()) error.add(readings);
  for (const double e : error.result(1)) EXPECT_TRUE(std::isnan(e));
}

}  // namespace
}  // namespace thiessen

#include "rainfall/errors/mean_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/errors/lasting_series.h"
#include "rainfall/errors/rainfall_error.h"

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

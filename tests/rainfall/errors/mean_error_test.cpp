#include "rainfall/errors/mean_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/errors/gaussian_field.h"
#include "rainfall/errors/rainfall_error.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr Ground plane{Metric::planar, 1, 0.1};
constexpr int side = 12;

/// Quarters of the unit square.
std::vector<Basin> quarters() {
  std::vector<Basin> basins;
  for (const Point low : {Point{0, 0}, Point{0.5, 0}, Point{0, 0.5}, Point{0.5, 0.5}}) {
    basins.push_back(shapes::basin({{shapes::rectangle(low, {low.x + 0.5, low.y + 0.5}), {}}}));
  }
  return basins;
}

struct Setting {
  const char* name;
  double lasting;  ///< share of the variance that is the same at all steps
  double share_silent;
  std::size_t steps;
};

/// A network of 40 gauges and what it reads in a series; the true means of the quarters.
class Series {
 public:
  Series(Seeded& seeded, const Setting& setting) {
    for (int g = 0; g < 40; ++g) {
      points_.push_back({seeded.uniform(-0.1, 1.1), seeded.uniform(-0.1, 1.1)});
      stations_.push_back({std::to_string(g), points_.back(), 0});
    }
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) points_.push_back({(i + 0.5) / side, (j + 0.5) / side});
    }
    const GaussianField field(points_, [](double d) { return std::exp(-d / 0.5); });
    const std::vector<double> lasting = field.draw(seeded);
    std::normal_distribution<double> normal;
    truth_.assign(4, 0);
    for (std::size_t t = 0; t < setting.steps; ++t) {
      std::vector<double> values = field.draw(seeded);
      const double common = 20 + 4 * normal(seeded.generator());  // what all gauges share
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = common + std::sqrt(1 - setting.lasting) * values[i] +
                    std::sqrt(setting.lasting) * lasting[i];
      }
      add_truth(values, static_cast<double>(setting.steps));
      values.resize(stations_.size());
      for (double& r : values) {
        if (seeded.uniform(0, 1) < setting.share_silent) r = silent;
      }
      steps_.push_back(std::move(values));
    }
  }

  const std::vector<Station>& stations() const { return stations_; }
  const std::vector<std::vector<double>>& steps() const { return steps_; }
  double truth(std::size_t basin) const { return truth_[basin]; }

 private:
  void add_truth(const std::vector<double>& values, double steps) {
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const std::size_t quarter = (i < side / 2 ? 0U : 1U) + (j < side / 2 ? 0U : 2U);
        const double value = values[stations_.size() + static_cast<std::size_t>(i * side + j)];
        truth_[quarter] += value * 4 / (side * side) / steps;
      }
    }
  }

  std::vector<Point> points_;
  std::vector<Station> stations_;
  std::vector<std::vector<double>> steps_;
  std::vector<double> truth_;
};

// Whether errors cancel from step to step or last, and with gaps, the mean's bars hold the truth in
// 93 to 97 % of cases, of which 2,000 tell to half a percent.
TEST(MeanError, has_bars_that_hold_the_true_mean) {
  Seeded seeded;
  const std::vector<Basin> basins = quarters();
  for (const Setting& setting :
       {Setting{"independent steps", 0, 0, 30}, Setting{"half of the variance lasts", 0.5, 0, 30},
        Setting{"independent, a fifth silent", 0, 0.2, 30},
        Setting{"half lasts, a fifth silent", 0.5, 0.2, 30}}) {
    double within = 0;
    double bars = 0;
    for (std::uint64_t round = Seeded::rounds(500); round > 0; --round) {
      const Series series(seeded, setting);
      const Network network(series.stations(), Metric::planar);
      const Weighing weighing(network, basins, plane);
      const ArealRainfall rainfall(weighing, {}, 1);
      MeanError error(rainfall, weighing);
      std::vector<double> sums(4, 0);
      for (const auto& readings : series.steps()) {
        error.add(readings);
        const auto values = rainfall.at(readings);
        for (std::size_t b = 0; b < 4; ++b) sums[b] += values[b].rainfall;
      }
      const std::vector<double> errors = error.result(1);
      for (std::size_t b = 0; b < 4; ++b) {
        const double mean = sums[b] / static_cast<double>(setting.steps);
        within += std::abs(mean - series.truth(b)) <= 1.96 * errors[b];
        ++bars;
      }
    }
    std::printf("%-32s %5.2f %%\n", setting.name, 100 * within / bars);
    EXPECT_GE(within / bars, 0.925) << setting.name;
    EXPECT_LE(within / bars, 0.975) << setting.name;
  }
}

// Law: where fields come in pairs of opposites about one that lasts, the mean is off as that one
// is.
TEST(MeanError, of_what_cancels_in_pairs_is_that_of_what_lasts) {
  Seeded seeded;
  const Series series(seeded, {"", 0, 0, 31});
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
  const Series series(seeded, {"", 0, 0, 5});
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

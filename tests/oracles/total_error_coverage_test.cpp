// What the standard errors of totals claim, against simulated fields that go on from step to step,
// whose true totals over the basins are known.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/errors_of_series.h"
#include "rainfall/errors/gaussian_field.h"
#include "rainfall/errors/lasting_series.h"
#include "rainfall/errors/total_error.h"

namespace thiessen {
namespace {

constexpr int side = 12;  // of the grid of points that the truth is a mean over
constexpr std::size_t gauges = 40;

/// A series whose field is at each step a share of that before, and whose variance changes; its
/// true means over the quarters of the unit square.
struct SteadySeries {
  std::vector<Station> stations;
  std::vector<std::vector<double>> steps;
  std::vector<std::vector<double>> truth;  ///< by step, then by quarter

  SteadySeries(Seeded& seeded, double correlation, std::size_t count) {
    std::vector<Point> points;
    for (std::size_t g = 0; g < gauges; ++g) {
      points.push_back({seeded.uniform(-0.1, 1.1), seeded.uniform(-0.1, 1.1)});
      stations.push_back({std::to_string(g), points.back(), 0});
    }
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) points.push_back({(i + 0.5) / side, (j + 0.5) / side});
    }
    const GaussianField field(points, [](double d) { return std::exp(-d / 0.5); });
    std::vector<double> values = field.draw(seeded);
    for (std::size_t t = 0; t < count; ++t) {
      const std::vector<double> fresh = field.draw(seeded);
      for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = correlation * values[i] + std::sqrt(1 - correlation * correlation) * fresh[i];
      }
      add(values, std::exp(seeded.uniform(-1, 1)));
    }
  }

 private:
  void add(const std::vector<double>& values, double scale) {
    std::vector<double>& readings = steps.emplace_back();
    for (std::size_t g = 0; g < gauges; ++g) readings.push_back(20 + scale * values[g]);
    std::vector<double>& means = truth.emplace_back(4, 20.0);
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) {
        const std::size_t quarter = (i < side / 2 ? 0U : 1U) + (j < side / 2 ? 0U : 2U);
        means[quarter] +=
            scale * values[gauges + static_cast<std::size_t>(i * side + j)] * 4 / (side * side);
      }
    }
  }
};

struct Held {
  double bars = 0;
  double within = 0;
  double share() const { return within / bars; }
};

/// Adds the totals of so many steps each.
void count(const SteadySeries& series, std::size_t length, Held& held) {
  const std::vector<Basin> basins = quarters();
  const Network network(series.stations, Metric::planar);
  const Weighing weighing(network, basins, {Metric::planar, 1, 0.1});
  ErrorsOfSeries errors(weighing, ErrorsOfSeries::Of::totals);
  for (const auto& readings : series.steps) errors.add(readings, {});
  const auto error =
      errors.of(std::make_unique<const ArealRainfall>(weighing, ArealRainfallSettings(), 1), {}, 1);
  const auto correlation = errors.correlation();
  for (std::size_t first = 0; first + length <= series.steps.size(); first += length) {
    std::vector<TotalError> totals(4);
    std::vector<double> off(4, 0);
    for (std::size_t t = first; t < first + length; ++t) {
      const auto values = error->at(series.steps[t]);
      for (std::size_t b = 0; b < 4; ++b) {
        totals[b].add(values[b], 1, *correlation);
        off[b] += values[b].rainfall - series.truth[t][b];
      }
    }
    for (std::size_t b = 0; b < 4; ++b) {
      ++held.bars;
      held.within += std::abs(off[b]) <= 1.96 * totals[b].standard_error(*correlation);
    }
  }
}

TEST(TotalErrorCoverage, of_fields_that_go_on_is_93_to_97_percent) {
  Seeded seeded;
  for (const double correlation : {0.0, 0.2, 0.4, 0.6, 0.8}) {
    Held months;
    Held years;
    for (std::uint64_t round = Seeded::rounds(20); round > 0; --round) {
      const SteadySeries series(seeded, correlation, 360);
      count(series, 30, months);
      count(series, 90, years);
    }
    std::printf("correlation %.1f: totals of 30 steps %5.2f %%, of 90 %5.2f %%\n", correlation,
                100 * months.share(), 100 * years.share());
    EXPECT_GE(months.share(), 0.93);
    EXPECT_LE(months.share(), 0.97);
    EXPECT_GE(years.share(), 0.92);  // of 320 bars
    EXPECT_LE(years.share(), 0.98);
  }
}

}  // namespace
}  // namespace thiessen

#include "rainfall/errors/errors_of_series.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/errors/lasting_series.h"
#include "rainfall/methods/rain_methods.h"
#include "rainfall/normals/doubtful_normals.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

/// 40 gauges and quarters of the unit square, with normals that a hill could have.
struct HillStudy {
  std::vector<double> of_gauges;
  std::vector<double> of_basins{30, 10, 20, 40};
  LastingSeries series;
  Network network;
  std::vector<Basin> basins = quarters();
  Weighing weighing;

  explicit HillStudy(Seeded& seeded)
      : series(seeded, {"", 0, 0.1, 30}),
        network(series.stations(), Metric::planar),
        weighing(network, basins, {Metric::planar, 1, 0.1}) {
    for (std::size_t g = 0; g < 40; ++g) of_gauges.push_back(seeded.uniform(10, 40));
  }
  /// A reading of the series times the gauge's normal relative to the first.
  std::vector<double> lifted(std::size_t step) const {
    std::vector<double> readings = series.steps()[step];
    for (std::size_t g = 0; g < readings.size(); ++g) readings[g] *= of_gauges[g] / of_gauges[0];
    return readings;
  }
  std::vector<std::vector<double>> columns(double times) const {
    std::vector<std::vector<double>> months;
    for (const double normal : of_gauges) months.push_back({normal, times * normal});
    return months;
  }
  std::vector<std::vector<double>> basin_columns() const {
    std::vector<std::vector<double>> months;
    for (const double normal : of_basins) months.push_back({normal, 3 * normal});
    return months;
  }
  std::unique_ptr<const RainfallError> errors(const ArealRainfallSettings& settings,
                                              bool lifts) const {
    ErrorsOfSeries errors(weighing);
    for (std::size_t t = 0; t < 30; ++t) errors.add(lifts ? lifted(t) : series.steps()[t], {});
    return errors.of(std::make_unique<const ArealRainfall>(weighing, settings, 1), {}, 1);
  }
};

// Readings that are lifted by the gauges' normals have the errors of the readings below, times the
// basin's normal, whatever the policy; and the error of the basin's own normal is added.
TEST(ErrorsOfSeries, with_normals_are_those_of_the_field_below_times_the_basins_normal) {
  Seeded seeded;
  HillStudy plain(seeded);
  HillStudy lifted = [&] {
    Seeded again;
    return HillStudy(again);
  }();
  lifted.weighing.take_normals(
      std::make_shared<const DoubtfulNormals>(lifted.of_gauges, lifted.of_basins, 0.01));
  for (const Gaps gaps : {Gaps::retessellate, Gaps::renormalise, Gaps::strict}) {
    const auto below = plain.errors({gaps}, false);
    const auto above = lifted.errors({gaps}, true);
    for (std::size_t t = 0; t < 5; ++t) {
      const auto of_plain = below->at(plain.series.steps()[t]);
      const auto of_lifted = above->at(lifted.lifted(t));
      for (std::size_t b = 0; b < 4; ++b) {
        ASSERT_EQ(std::isnan(of_plain[b].rainfall), std::isnan(of_lifted[b].rainfall));
        if (std::isnan(of_plain[b].rainfall)) continue;
        const double normal = lifted.of_basins[b] / lifted.of_gauges[0];
        EXPECT_NEAR(of_lifted[b].rainfall / (normal * of_plain[b].rainfall), 1, 1e-12);
        EXPECT_NEAR(of_lifted[b].error_of_step / (normal * of_plain[b].standard_error), 1, 1e-6);
        EXPECT_NEAR(of_lifted[b].error_of_normals, 0.1 * of_lifted[b].rainfall, 1e-9);
        EXPECT_DOUBLE_EQ(of_lifted[b].standard_error,
                         std::hypot(of_lifted[b].error_of_step, of_lifted[b].error_of_normals));
        EXPECT_EQ(of_plain[b].error_of_step, of_plain[b].standard_error);
      }
    }
  }
}

// The second month has three times the normals of the first: readings of that month are lifted by
// the same, for the first station's is the measure of each month, and its basins are in the same
// ratio to the gauges.
TEST(ErrorsOfSeries, of_months_go_by_each_months_normals) {
  Seeded seeded;
  HillStudy study(seeded);
  study.weighing.take_normals(
      std::make_shared<const UniformNormals>(study.columns(3), study.basin_columns()));
  ErrorsOfSeries errors(study.weighing);
  for (std::size_t t = 0; t < 30; ++t) errors.add(study.lifted(t), t % 2);
  const ArealRainfall rainfall(study.weighing, {}, 1);
  const auto first = errors.of(rainfall.of_month(0), 0, 1);
  const auto second = errors.of(rainfall.of_month(1), 1, 1);
  for (std::size_t t = 0; t < 3; ++t) {
    const auto a = first->at(study.lifted(t));
    const auto b = second->at(study.lifted(t));
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_GT(a[i].standard_error, 0);
      EXPECT_NEAR(a[i].standard_error / b[i].standard_error, 1, 1e-9);
    }
  }
}

TEST(ErrorsOfSeries, with_normals_that_are_the_same_everywhere_are_as_without) {
  Seeded seeded;
  HillStudy study(seeded);
  const auto without = study.errors({}, false);
  HillStudy flat = [&] {
    Seeded again;
    return HillStudy(again);
  }();
  flat.weighing.take_normals(std::make_shared<const UniformNormals>(
      std::vector<std::vector<double>>(40, {0.3}), std::vector<std::vector<double>>(4, {0.3})));
  const auto with = flat.errors({}, false);
  for (std::size_t t = 0; t < 5; ++t) {
    const auto a = without->at(study.series.steps()[t]);
    const auto b = with->at(flat.series.steps()[t]);
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(a[i].rainfall, b[i].rainfall);
      EXPECT_NEAR(a[i].standard_error / b[i].standard_error, 1, 1e-12);
    }
  }
}

// Each method has the block kriging variance of its own weights: where all gauges lie in a basin
// and each has the same weight in it, two methods agree.
TEST(ErrorsOfSeries, are_of_each_methods_own_weights) {
  Seeded seeded;
  HillStudy study(seeded);
  ErrorsOfSeries errors(study.weighing);
  for (std::size_t t = 0; t < 30; ++t) errors.add(study.series.steps()[t], {});
  Warnings warnings;
  std::vector<std::unique_ptr<const RainfallError>> all;
  const auto several = rainfall_by(
      {RainMethod::thiessen, RainMethod::arithmetic, RainMethod::idw, RainMethod::natural},
      study.weighing, {400, 0}, {}, 1, warnings,
      [&](std::unique_ptr<const WeighedRainfall> rainfall, const NormalMonth& month) {
        return errors.of(std::move(rainfall), month, 1);
      });
  const auto thiessen = study.errors({}, false);
  for (std::size_t t = 0; t < 5; ++t) {
    const auto values = several->at(study.series.steps()[t]);
    const auto weights = several->weights_at(study.series.steps()[t]);
    const auto alone = thiessen->at(study.series.steps()[t]);
    ASSERT_EQ(values.size(), 16u);
    for (std::size_t b = 0; b < 4; ++b) {
      EXPECT_EQ(values[4 * b].standard_error, alone[b].standard_error);
      for (std::size_t m = 0; m < 4; ++m) {
        if (std::isnan(values[4 * b + m].rainfall)) continue;
        EXPECT_GT(values[4 * b + m].standard_error, 0);
        EXPECT_LT(values[4 * b + m].standard_error, 3 * alone[b].standard_error);
      }
    }
  }
}

}  // namespace
}  // namespace thiessen

#include "rainfall/errors/error_correlation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/network/network.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// Gauges on a line.
Network line(std::size_t gauges) {
  std::vector<Station> stations;
  for (std::size_t g = 0; g < gauges; ++g)
    stations.push_back({std::to_string(g), {static_cast<double>(g), 0}, 0});
  return {stations, Metric::planar};
}

// Gauges that differ by the same at all steps, and more where it rains more: all of it lasts.
TEST(DifferencesInTime, that_are_always_the_same_last) {
  const Network network = line(12);
  DifferencesInTime differences(network, Metric::planar);
  for (int t = 0; t < 40; ++t) {
    std::vector<double> values;
    for (int g = 0; g < 12; ++g) values.push_back((1 + t % 5) * (10 + (g * g) % 7));
    differences.add(values);
  }
  const ErrorCorrelation found = differences.result();
  EXPECT_NEAR(found.lasting, 1, 1e-12);
  for (const std::size_t lag : {1u, 5u, 100u}) EXPECT_NEAR(found.at(lag), 1, 1e-12);
  EXPECT_EQ(found.at(0), 1);
}

// Signs that change at each step: opposite at odd lags, the same at even ones.
TEST(DifferencesInTime, that_change_sign_are_opposite_at_odd_lags) {
  const Network network = line(60);
  DifferencesInTime differences(network, Metric::planar);
  for (int t = 0; t < 40; ++t) {
    std::vector<double> values;
    for (int g = 0; g < 60; ++g) values.push_back((t % 2 == 0 ? 1 : -1) * ((g * g) % 7));
    differences.add(values);
  }
  const ErrorCorrelation found = differences.result();
  ASSERT_EQ(found.at_lags.size(), 10u);  // a quarter of the steps
  EXPECT_NEAR(found.at(1), -1, 1e-12);
  EXPECT_NEAR(found.at(2), 1, 1e-12);
  EXPECT_EQ(found.lasting, 0);
}

/// Independent values of gauges of which each step keeps a share of the one before, a tenth silent.
ErrorCorrelation of_steady(Seeded& seeded, double share, std::size_t steps) {
  const Network network = line(100);
  DifferencesInTime differences(network, Metric::planar);
  std::normal_distribution<double> normal;
  std::vector<double> values(100);
  for (double& value : values) value = normal(seeded.generator());
  for (std::size_t t = 0; t < steps; ++t) {
    std::vector<double> told;
    const double scale = seeded.uniform(0.2, 5);
    for (double& value : values) {
      value = share * value + std::sqrt(1 - share * share) * normal(seeded.generator());
      told.push_back(seeded.uniform(0, 1) < 0.1 ? silent : scale * value);
    }
    differences.add(told);
  }
  return differences.result();
}

TEST(DifferencesInTime, tell_the_correlation_of_steps_whose_variance_changes) {
  Seeded seeded;
  const ErrorCorrelation steady = of_steady(seeded, 0.7, 1000);
  EXPECT_NEAR(steady.at(1), 0.7, 0.03);
  EXPECT_NEAR(steady.at(2), 0.49, 0.03);
  EXPECT_NEAR(steady.at(4), 0.24, 0.03);
  EXPECT_EQ(steady.at(200), 0);
  EXPECT_EQ(steady.lasting, 0);
  // Of 32 lags some are told from 0 by chance.
  for (const double at_lag : of_steady(seeded, 0, 1000).at_lags) EXPECT_LT(std::abs(at_lag), 0.05);
}

TEST(DifferencesInTime, of_nothing_are_none) {
  const Network network = line(5);
  DifferencesInTime differences(network, Metric::planar);
  EXPECT_EQ(differences.result().lasting, 0);
  for (int t = 0; t < 20; ++t) differences.add(std::vector<double>(5, t % 2 == 0 ? 3.0 : silent));
  EXPECT_TRUE(differences.result().at_lags.empty());
  EXPECT_EQ(differences.result().lasting, 0);
}

TEST(ErrorCorrelation, that_lasts_is_warned_of) {
  Warnings warnings;
  warn_of_lasting_errors({{0.1}, 0}, "rain.csv", warnings);
  EXPECT_TRUE(warnings.messages().empty());
  warn_of_lasting_errors({{}, 0.4123}, "rain.csv", warnings);
  ASSERT_EQ(warnings.messages().size(), 1u);
  EXPECT_EQ(warnings.messages()[0].text,
            "near gauges differ for good: 41.2 % of the square of an error lasts from step to "
            "step, which the errors of totals count alike in plains and mountains");
  EXPECT_EQ(warnings.messages()[0].hint.plain(),
            "normals tell where it is wetter: 'normals', 'normal_field', 'elevation'");
}

}  // namespace
}  // namespace thiessen

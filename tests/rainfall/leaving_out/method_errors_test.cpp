#include "rainfall/leaving_out/method_errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/leaving_out/left_out_readings.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

Network square() {
  return {{{"a", {0, 0}}, {"b", {1, 0}}, {"c", {1, 1}}, {"d", {0, 1}}, {"e", {0.5, 0.5}}},
          Metric::planar};
}

std::size_t number_of(const MethodErrors& errors, PointMethod method, bool with_normals) {
  for (std::size_t m = 0; m < errors.methods().size(); ++m) {
    if (errors.methods()[m].method == method && errors.methods()[m].with_normals == with_normals)
      return m;
  }
  ADD_FAILURE();
  return 0;
}

ErrorSums steps_of(const MethodErrors& errors, PointMethod method, bool with_normals = false) {
  return errors.errors(number_of(errors, method, with_normals)).steps;
}

// By hand: see LeftOutEstimates.of_a_square_by_hand for what each is told.
TEST(MethodErrors, of_a_square_by_hand) {
  const Network network = square();
  MethodErrors errors(network, Metric::planar, {}, nullptr, 1);
  const std::vector<double> readings{10, 20, 30, 40, 50};
  errors.add({readings});
  errors.finish();
  EXPECT_EQ(errors.readings(), 5u);
  EXPECT_EQ(errors.gauges(), 5u);
  EXPECT_EQ(errors.methods().size(), 5u);
  EXPECT_EQ(steps_of(errors, PointMethod::thiessen).errors, 40 + 30 + 20 + 10 - 40);
  EXPECT_EQ(steps_of(errors, PointMethod::thiessen).squares, 1600 + 900 + 400 + 100 + 1600);
  EXPECT_EQ(steps_of(errors, PointMethod::arithmetic).squares, 625 + 156.25 + 0 + 156.25 + 625);
  EXPECT_NEAR(steps_of(errors, PointMethod::idw).root_mean_square(), 18.9231, 1e-4);
  EXPECT_NEAR(steps_of(errors, PointMethod::natural).squares, 1600 + 900 + 400 + 100 + 625, 1e-9);
  EXPECT_NEAR(steps_of(errors, PointMethod::linear).squares, 1600 + 900 + 400 + 100 + 400, 1e-9);
  const SquaredDifference difference = errors.difference(1, 0);
  EXPECT_NEAR(difference.mean, -607.5, 1e-9);
  EXPECT_NEAR(difference.t, -3.0915, 1e-4);
}

// The second year lacks a reading of e, and with it what it is told.
TEST(MethodErrors, of_sums_of_years) {
  const Network network = square();
  MethodErrors errors(network, Metric::planar, {}, nullptr, 1);
  const std::vector<double> all{10, 20, 30, 40, 50};
  const std::vector<double> gap{10, 20, 30, 40, silent};
  errors.add({all, {}, 2001});
  errors.add({all, {}, 2001});
  errors.add({all, {}, 2002});
  errors.add({gap, {}, 2002});
  errors.finish();
  const ErrorSums years = errors.errors(number_of(errors, PointMethod::arithmetic, false)).years;
  EXPECT_EQ(years.count, 10u);
  // Without e: a is told 30, b 80 / 3, c 70 / 3, d 20.
  const double a = 25 + 20;
  const double b = 12.5 + 80 / 3.0 - 20;
  const double c = 70 / 3.0 - 30;
  const double d = -12.5 - 20;
  EXPECT_NEAR(years.squares,
              4 * (625 + 156.25 + 156.25 + 625) + a * a + b * b + c * c + d * d + 625, 1e-9);
}

TEST(MethodErrors, by_bands) {
  std::vector<Station> stations;
  for (int i = 0; i < 6; ++i) stations.push_back({std::to_string(i), {i * (1 + 0.1 * i), 0}});
  const Network network(stations, Metric::planar);
  const ElevationBands bands(std::vector<double>{1, 1, 1, 9, 9, 9});
  MethodErrors errors(network, Metric::planar, {}, nullptr, 1);
  const std::vector<double> readings{0, 1, 3, 6, 10, 15};
  errors.add({readings});
  errors.finish();
  EXPECT_EQ(errors.errors(0, bands, 0).steps.errors, 1 - 1 - 2);
  EXPECT_EQ(errors.errors(0, bands, 1).steps.errors, -3 - 4 - 5);
}

// Readings that are normal x state exactly have no error with normals, by any method.
TEST(MethodErrors, of_normals_that_say_all_are_none) {
  Seeded seeded;
  std::vector<Station> stations;
  std::vector<std::vector<double>> normals;
  for (int i = 0; i < 40; ++i) {
    stations.push_back({std::to_string(i), {seeded.uniform(0, 9), seeded.uniform(0, 9)}});
    normals.push_back({seeded.uniform(100, 900)});
  }
  const Network network(stations, Metric::planar);
  const UniformNormals field(normals, {});
  MethodErrors errors(network, Metric::planar, {}, &field, 1);
  std::vector<double> readings;
  for (const auto& normal : normals) readings.push_back(0.3 * normal[0]);
  errors.add({readings});
  errors.finish();
  EXPECT_EQ(errors.methods().size(), 10u);
  for (const PointMethod method : point_methods) {
    EXPECT_NEAR(steps_of(errors, method, true).squares, 0, 1e-18) << name_of(method);
    EXPECT_GT(steps_of(errors, method).squares, 1) << name_of(method);
  }
}

// The nearest gauge's errors are those that are said of fitted normals.
TEST(MethodErrors, of_the_nearest_are_those_of_left_out_readings) {
  Seeded seeded;
  std::vector<Station> stations;
  std::vector<std::vector<double>> normals;
  for (int i = 0; i < 50; ++i) {
    stations.push_back({std::to_string(i), {seeded.uniform(7, 9), seeded.uniform(46, 47)}});
    normals.emplace_back();
    for (int m = 0; m < 12; ++m) normals.back().push_back(seeded.uniform(100, 900));
  }
  stations[49].position = stations[48].position;  // one place
  const Network network(stations, Metric::geodesic);
  const UniformNormals field(normals, {});
  MethodErrors errors(network, Metric::geodesic, {}, &field, 1);
  LeftOutReadings nearest(network, Metric::geodesic, &field, ElevationBands({}));
  for (std::size_t t = 0; t < 30; ++t) {
    std::vector<double> readings;
    for (int i = 0; i < 50; ++i)
      readings.push_back(seeded.uniform(0, 1) < 0.3 ? silent : seeded.uniform(0, 80));
    errors.add({readings, t % 12});
    nearest.add(readings, t % 12);
  }
  errors.finish();
  EXPECT_EQ(errors.readings(), nearest.all().plain.count);
  EXPECT_NEAR(steps_of(errors, PointMethod::thiessen).squares, nearest.all().plain.squares, 1e-6);
  EXPECT_NEAR(steps_of(errors, PointMethod::thiessen, true).squares,
              nearest.all().with_normals.squares, 1e-6 * nearest.all().with_normals.squares);
}

TEST(MethodErrors, of_steps_at_which_one_gauge_reports_are_none) {
  const Network network = square();
  MethodErrors errors(network, Metric::planar, {}, nullptr, 1);
  const std::vector<double> one{silent, 3, silent, silent, silent};
  const std::vector<double> none(5, silent);
  errors.add({one, {}, 2001});
  errors.add({none, {}, 2001});
  errors.finish();
  EXPECT_EQ(errors.readings(), 0u);
  EXPECT_EQ(errors.errors(0).years.count, 0u);
}

}  // namespace
}  // namespace thiessen

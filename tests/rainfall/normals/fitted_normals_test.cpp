#include "rainfall/normals/fitted_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct Net {
  std::vector<Point> places;
  std::vector<double> elevations;
  std::vector<double> normals;

  FittedNormals fit() const { return {places, elevations, normals, Metric::geodesic, 1}; }
};

/// Gauges whose normal doubles with each 1,000 m, but for a factor up to `scatter`.
Net mountains(Seeded& seeded, double scatter) {
  Net net;
  for (int i = 0; i < 60; ++i) {
    net.places.push_back({seeded.uniform(7, 9), seeded.uniform(46, 47)});
    net.elevations.push_back(seeded.uniform(200, 3200));
    net.normals.push_back(600 * std::exp2(net.elevations.back() / 1000) *
                          std::exp(seeded.uniform(-scatter, scatter)));
  }
  return net;
}

TEST(FittedNormals, follow_the_elevation) {
  Seeded seeded;
  const Net net = mountains(seeded, 0);
  const FittedNormals fitted = net.fit();
  EXPECT_NEAR(std::exp(fitted.at({8, 46.5}).value(1500)), 600 * std::exp2(1.5), 1e-3);
  EXPECT_NEAR(fitted.without(5), net.normals[5], 1e-3);
  EXPECT_TRUE(fitted.is_better_than_nearest());
}

TEST(FittedNormals, of_a_gauge_are_its_own) {
  Seeded seeded;
  const Net net = mountains(seeded, 0.2);
  const FittedNormals fitted = net.fit();
  EXPECT_NEAR(fitted.at_place(7), net.normals[7], 1e-9 * net.normals[7]);
  EXPECT_NE(fitted.without(7), net.normals[7]);
}

TEST(FittedNormals, of_a_gauge_without_one_are_what_the_others_tell) {
  Seeded seeded;
  Net net = mountains(seeded, 0);
  const double truth = net.normals[3];
  for (const double unknown : {none, 0.0}) {
    net.normals[3] = unknown;
    const FittedNormals fitted = net.fit();
    EXPECT_NEAR(fitted.at_place(3), truth, 1e-3);
    EXPECT_EQ(fitted.without(3), fitted.at_place(3));
  }
}

TEST(FittedNormals, that_gain_nothing_are_known) {
  Seeded seeded;
  Net alike = mountains(seeded, 0);
  for (double& normal : alike.normals) normal = 700;
  EXPECT_FALSE(alike.fit().is_better_than_nearest());

  // Each gauge has a twin beside it with the same normal.
  Net twins = mountains(seeded, 0);
  for (std::size_t i = 0; i < twins.places.size(); i += 2) {
    twins.places[i + 1] = {twins.places[i].x + 1e-4, twins.places[i].y};
    twins.normals[i] = twins.normals[i + 1] = seeded.uniform(500, 2000);
  }
  EXPECT_FALSE(twins.fit().is_better_than_nearest());
}

}  // namespace
}  // namespace thiessen

#include "rainfall/normals/elevation_fit.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/errors/gaussian_field.h"

namespace thiessen {
namespace {

struct Net {
  std::vector<Point> places;
  std::vector<double> elevations;
  std::vector<std::vector<double>> normals;  // by month

  ElevationFit fit() const { return {places, elevations, normals, Metric::planar, 1}; }
};

/// Places in a square of 100, between 0 and 3,000 high.
Net scattered(Seeded& seeded, std::size_t count) {
  Net net;
  for (std::size_t i = 0; i < count; ++i) {
    net.places.push_back({seeded.uniform(0, 100), seeded.uniform(0, 100)});
    net.elevations.push_back(seeded.uniform(0, 3000));
  }
  return net;
}

/// Adds a month in which rain grows by a share for each unit of elevation.
void add_month(Net& net, double at_sea, double slope) {
  std::vector<double>& normals = net.normals.emplace_back();
  for (const double z : net.elevations) normals.push_back(at_sea * std::exp(slope * z));
}

TEST(ElevationFits, tell_what_elevation_tells_in_each_month) {
  Seeded seeded;
  Net net = scattered(seeded, 60);
  add_month(net, 50, 4e-4);
  add_month(net, 80, -1e-4);
  const ElevationFit fit = net.fit();
  EXPECT_TRUE(fit.is_better_than_nearest());
  std::array<ToldNormal, 2> told;
  fit.at({40, 60}, told);
  EXPECT_NEAR(std::exp(told[0].line.value(1000)), 50 * std::exp(0.4), 1e-4);
  EXPECT_NEAR(std::exp(told[1].line.value(2000)), 80 * std::exp(-0.2), 1e-4);
  EXPECT_NEAR(fit.at_place(7, 1), net.normals[1][7], 1e-9);
  EXPECT_NEAR(fit.without(7, 0), net.normals[0][7], 1e-3);
}

TEST(ElevationFits, do_not_see_places_without_normals) {
  Seeded seeded;
  Net net = scattered(seeded, 60);
  add_month(net, 50, 4e-4);
  add_month(net, 80, -1e-4);
  const ElevationFit fit = net.fit();
  Net more = net;
  const Net silent = scattered(seeded, 30);
  const auto put_first = [](auto& list, const auto& other) {
    list.insert(list.begin(), other.begin(), other.end());
  };
  put_first(more.places, silent.places);
  put_first(more.elevations, silent.elevations);
  for (auto& of_month : more.normals) of_month.insert(of_month.begin(), 30, 0);
  const ElevationFit with_silent = more.fit();
  EXPECT_EQ(with_silent.spacing(), fit.spacing());
  EXPECT_EQ(with_silent.first_gauge(), fit.first_gauge());
  EXPECT_EQ(with_silent.left_out_error(), fit.left_out_error());
  std::array<ToldNormal, 2> told;
  std::array<ToldNormal, 2> told_with_silent;
  for (const Point silent_place : silent.places) {
    fit.at(silent_place, told);
    with_silent.at(silent_place, told_with_silent);
    for (const std::size_t month : {0U, 1U})
      EXPECT_EQ(told_with_silent[month].nearest, told[month].nearest);
  }
  for (std::size_t place = 0; place < net.places.size(); ++place)
    EXPECT_EQ(with_silent.without(30 + place, 1), fit.without(place, 1));
}

TEST(ElevationFits, find_a_truth_with_noise_better_than_the_nearest_gauge) {
  // ln N = 4 + 4e-4 z + S + noise: S has a standard deviation of 0.15 and a range of 40, the noise
  // one of 0.03. The nearest of 150 gauges differs by 1,225 in elevation (uniform over 3,000,
  // root mean square), so by 0.49 and more in ln N; the fit by little more than S and noise.
  Seeded seeded;
  Net net = scattered(seeded, 150);
  const GaussianField field(net.places, [](double d) { return std::exp(-d / 40); });
  const std::vector<double> drawn = field.draw(seeded);
  std::vector<double>& normals = net.normals.emplace_back();
  for (std::size_t i = 0; i < net.places.size(); ++i) {
    normals.push_back(
        std::exp(4 + 4e-4 * net.elevations[i] + 0.15 * drawn[i] + seeded.uniform(-0.05, 0.05)));
  }
  const ElevationFit fit = net.fit();
  EXPECT_TRUE(fit.is_better_than_nearest());
  EXPECT_LT(fit.left_out_error(), 0.15);
  EXPECT_GT(fit.nearest_error(), 0.4);
  // Without elevations the mean of many gauges is left, which differs by 0.35 as one gauge does.
  EXPECT_GT(fit.level_error(), 0.3);
  // The truth of the drift is found between gauges, too.
  double slopes = 0;
  for (double x = 10; x < 100; x += 10) {
    ToldNormal told;
    fit.at({x, 50}, {&told, 1});
    slopes += told.line.slope / 9;
  }
  EXPECT_NEAR(slopes, 4e-4, 2e-5);
}

TEST(ElevationFits, owe_nothing_to_elevation_that_tells_nothing) {
  // ln N = 4 + S + noise: the mean of the gauges around is better than the nearest gauge, and a
  // slope that has to be fitted adds to its error, by half a fortieth of it and by chance.
  Seeded seeded;
  double with = 0;
  double without = 0;
  for (int round = 0; round < 4; ++round) {
    Net net = scattered(seeded, 150);
    const GaussianField field(net.places, [](double d) { return std::exp(-d / 40); });
    const std::vector<double> drawn = field.draw(seeded);
    std::vector<double>& normals = net.normals.emplace_back();
    for (const double s : drawn)
      normals.push_back(std::exp(4 + 0.1 * s + seeded.uniform(-0.2, 0.2)));
    const ElevationFit fit = net.fit();
    EXPECT_TRUE(fit.is_better_than_nearest());
    with += fit.left_out_error() * fit.left_out_error();
    without += fit.level_error() * fit.level_error();
  }
  EXPECT_LT(without, with);
  EXPECT_LT(with, 1.1 * without);
}

TEST(ElevationFits, are_no_better_where_elevation_tells_nothing) {
  // Gauges stand in pairs, one in the valley and one on the slope above, with nearly the same rain:
  // what differs from pair to pair has nothing to do with elevation, and no average of many gauges
  // tells more than the other of the pair.
  Seeded seeded;
  Net net = scattered(seeded, 120);
  std::vector<double>& normals = net.normals.emplace_back();
  for (std::size_t i = 0; i < net.places.size(); i += 2) {
    net.places[i + 1] = {net.places[i].x + 0.5, net.places[i].y};
    const double of_pair = seeded.uniform(4, 6);
    normals.push_back(std::exp(of_pair + seeded.uniform(-0.02, 0.02)));
    normals.push_back(std::exp(of_pair + seeded.uniform(-0.02, 0.02)));
  }
  EXPECT_FALSE(net.fit().is_better_than_nearest());
}

TEST(ElevationFits, hold_what_they_tell_by_the_nearest_gauge) {
  EXPECT_EQ(held_logarithm(5, 4.5), 5);
  EXPECT_DOUBLE_EQ(held_logarithm(9, 4.5), 4.5 + std::log(4));
  EXPECT_DOUBLE_EQ(held_logarithm(-9, 4.5), 4.5 - std::log(4));
  // A summit beside a valley's gauge: the others tell ten times its normal.
  Seeded seeded;
  Net net = scattered(seeded, 40);
  for (std::size_t i = 0; i < 40; ++i)
    net.elevations[i] = i == 0 ? 3000 : 25.0 * static_cast<double>(i);
  net.places[1] = {net.places[0].x + 1e-3, net.places[0].y};
  net.elevations[1] = 0;
  add_month(net, 50, std::log(10) / 3000);
  EXPECT_NEAR(net.fit().without(0, 0), 4 * 50, 1e-6);
}

TEST(ElevationFits, know_how_far_gauges_are_apart) {
  // A square lattice: each gauge has a square of 10 to itself.
  Net net;
  Seeded seeded;
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      net.places.push_back({10.0 * i, 10.0 * j});
      net.elevations.push_back(seeded.uniform(0, 3000));
    }
  }
  add_month(net, 50, 1e-4);
  EXPECT_NEAR(net.fit().spacing(), 10, 1.5);
}

}  // namespace
}  // namespace thiessen

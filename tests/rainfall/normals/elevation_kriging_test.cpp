#include "rainfall/normals/elevation_kriging.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/errors/gaussian_field.h"

namespace thiessen {
namespace {

struct Net {
  std::vector<Point> places;
  std::vector<double> elevations;
  std::vector<double> values;

  ElevationKriging kriging() const { return {places, elevations, values, Metric::planar, 1}; }
};

Net random_net(Seeded& seeded, std::size_t count) {
  Net net;
  for (std::size_t i = 0; i < count; ++i) {
    net.places.push_back({seeded.uniform(0, 100), seeded.uniform(0, 100)});
    net.elevations.push_back(seeded.uniform(0, 3000));
  }
  const GaussianField field(net.places, [](double d) { return std::exp(-d / 20); });
  const std::vector<double> drawn = field.draw(seeded);
  for (std::size_t i = 0; i < count; ++i)
    net.values.push_back(4 + 2e-4 * net.elevations[i] + 0.3 * drawn[i] + seeded.uniform(-.1, .1));
  return net;
}

/// Solves by elimination with full pivoting, in long doubles.
std::vector<long double> solved(std::vector<std::vector<long double>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t c = 0; c < n; ++c) {
    const auto largest = std::max_element(
        rows.begin() + static_cast<std::ptrdiff_t>(c), rows.end(),
        [&](const auto& a, const auto& b) { return std::abs(a[c]) < std::abs(b[c]); });
    std::swap(rows[c], *largest);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const long double factor = rows[r][c] / rows[c][c];
      for (std::size_t k = c; k <= n; ++k) rows[r][k] -= factor * rows[c][k];
    }
  }
  std::vector<long double> x;
  for (std::size_t r = 0; r < n; ++r) x.push_back(rows[r][n] / rows[r][r]);
  return x;
}

struct Told {
  double value;
  double variance;
};

/// The textbook's system of equations, with the two multipliers: its solution is the weights.
Told by_the_whole_system(const Net& net, const VariogramModel& model, Point x, double z) {
  std::vector<std::size_t> near(net.places.size());
  std::iota(near.begin(), near.end(), 0u);
  const auto distance = [](Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); };
  std::sort(near.begin(), near.end(), [&](std::size_t a, std::size_t b) {
    return distance(net.places[a], x) < distance(net.places[b], x);
  });
  near.resize(std::min(near.size(), ElevationKriging::neighbours));
  const std::size_t n = near.size();
  const auto covariance = [&](double d) { return model.sill * (1 - model.rise(d)); };
  std::vector<std::vector<long double>> rows(n + 2, std::vector<long double>(n + 3));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      rows[i][j] = covariance(distance(net.places[near[i]], net.places[near[j]]));
    rows[i][i] += model.nugget;
    rows[i][n] = rows[n][i] = 1;
    rows[i][n + 1] = rows[n + 1][i] = net.elevations[near[i]];
    rows[i][n + 2] = covariance(distance(net.places[near[i]], x));
  }
  rows[n][n + 2] = 1;
  rows[n + 1][n + 2] = z;
  const std::vector<long double> solution = solved(rows);
  long double value = 0;
  long double variance = model.sill - solution[n] - solution[n + 1] * z;
  for (std::size_t i = 0; i < n; ++i) {
    value += solution[i] * net.values[near[i]];
    variance -= solution[i] * rows[i][n + 2];
  }
  return {static_cast<double>(value), static_cast<double>(variance)};
}

TEST(ElevationKriging, solves_the_textbooks_equations) {
  Seeded seeded;
  for (const std::size_t count : {5u, 39u, 41u, 90u}) {
    const Net net = random_net(seeded, count);
    const ElevationKriging kriging = net.kriging();
    for (int i = 0; i < 10; ++i) {
      const Point x{seeded.uniform(-20, 120), seeded.uniform(-20, 120)};
      const double z = seeded.uniform(-100, 4000);
      const Told want = by_the_whole_system(net, kriging.variogram(), x, z);
      const ElevationLine line = kriging.at(x);
      EXPECT_NEAR(line.value(z), want.value, 1e-8) << count;
      EXPECT_NEAR(line.variance(z), want.variance * kriging.calibration_at(x),
                  1e-8 * (1 + std::abs(want.variance)))
          << count;
    }
  }
}

TEST(ElevationKriging, without_a_place_is_the_kriging_of_all_others) {
  Seeded seeded;
  const Net net = random_net(seeded, 60);
  const ElevationKriging kriging = net.kriging();
  for (const std::size_t left_out : {0u, 17u, 59u}) {
    Net others = net;
    const auto at = static_cast<std::ptrdiff_t>(left_out);
    others.places.erase(others.places.begin() + at);
    others.elevations.erase(others.elevations.begin() + at);
    others.values.erase(others.values.begin() + at);
    const Point x = net.places[left_out];
    const double z = net.elevations[left_out];
    EXPECT_NEAR(kriging.without(left_out).value(z),
                by_the_whole_system(others, kriging.variogram(), x, z).value, 1e-8);
  }
}

TEST(ElevationKriging, finds_a_straight_line_exactly) {
  Seeded seeded;
  Net net = random_net(seeded, 50);
  for (std::size_t i = 0; i < 50; ++i) net.values[i] = 3 + 1e-3 * net.elevations[i];
  const ElevationKriging kriging = net.kriging();
  const ElevationLine line = kriging.at({120, -10});
  EXPECT_NEAR(line.constant, 3, 1e-6);
  EXPECT_NEAR(line.slope, 1e-3, 1e-9);
  EXPECT_LT(kriging.left_out_error(), 1e-6);
  EXPECT_GT(kriging.nearest_error(), 0.1);
}

TEST(ElevationKriging, knows_what_the_others_tell_without_elevation) {
  // Three places as far from each other: without elevation two tell the third their mean, whatever
  // the variogram.
  const double h = std::sqrt(3.0) / 2;
  const Net net{{{0, 0}, {1, 0}, {0.5, h}}, {10, 500, 200}, {1, 2, 6}};
  const double sum = 9;
  double squares = 0;
  for (const double value : net.values) squares += std::pow((sum - value) / 2 - value, 2);
  EXPECT_NEAR(net.kriging().level_error(), std::sqrt(squares / 3), 1e-9);
}

TEST(ElevationKriging, has_no_slope_where_all_stand_at_one_height) {
  Seeded seeded;
  Net net = random_net(seeded, 30);
  std::fill(net.elevations.begin(), net.elevations.end(), 250.0);
  const ElevationLine line = net.kriging().at({50, 50});
  EXPECT_EQ(line.slope, 0);
  EXPECT_TRUE(std::isfinite(line.value(1000)));
}

TEST(ElevationKriging, of_values_that_are_all_the_same) {
  Seeded seeded;
  Net net = random_net(seeded, 20);
  std::fill(net.values.begin(), net.values.end(), 1.5);
  const ElevationLine line = net.kriging().at({50, 50});
  EXPECT_NEAR(line.value(800), 1.5, 1e-12);
  EXPECT_NEAR(line.variance(800), 0, 1e-12);
}

TEST(ElevationKriging, does_not_depend_on_the_order_of_the_places) {
  Seeded seeded;
  const Net net = random_net(seeded, 70);
  Net turned = net;
  std::reverse(turned.places.begin(), turned.places.end());
  std::reverse(turned.elevations.begin(), turned.elevations.end());
  std::reverse(turned.values.begin(), turned.values.end());
  const ElevationKriging a = net.kriging();
  const ElevationKriging b = turned.kriging();
  EXPECT_NEAR(a.calibration(), b.calibration(), 1e-9 * a.calibration());
  EXPECT_NEAR(a.at({30, 60}).value(900), b.at({30, 60}).value(900), 1e-9);
}

// The field between gauges is drawn with them: the error over its standard error has a mean square
// of 1.
TEST(ElevationKriging, tells_how_far_it_is_off) {
  Seeded seeded;
  double ratios = 0;
  int count = 0;
  for (int draw = 0; draw < 40; ++draw) {
    Net all = random_net(seeded, 120);
    Net known = all;
    known.places.resize(100);
    known.elevations.resize(100);
    known.values.resize(100);
    const ElevationKriging kriging = known.kriging();
    for (std::size_t i = 100; i < 120; ++i) {
      const ElevationLine line = kriging.at(all.places[i]);
      const double off = line.value(all.elevations[i]) - all.values[i];
      ratios += off * off / (line.variance(all.elevations[i]) + kriging.nugget());
      ++count;
    }
  }
  EXPECT_NEAR(ratios / count, 1, 0.2);
}

// In the east values scatter four times as much as in the west: so do the standard errors, but for
// what is taken from all.
TEST(ElevationKriging, is_the_less_sure_the_more_the_near_places_scatter) {
  Seeded seeded;
  Net net = random_net(seeded, 400);
  std::normal_distribution<double> normal;
  for (std::size_t i = 0; i < 400; ++i) {
    const double scatter = net.places[i].x < 50 ? 0.05 : 0.2;
    net.values[i] = 1e-3 * net.elevations[i] + scatter * normal(seeded.generator());
  }
  const ElevationKriging kriging = net.kriging();
  const double ratio = kriging.calibration_at({90, 50}) / kriging.calibration_at({10, 50});
  EXPECT_GT(ratio, 3);
  EXPECT_LT(ratio, 16);
}

}  // namespace
}  // namespace thiessen

#include "rainfall/normals/elevation_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A pixel is a unit of the study's plane, and rows run south from y = 100.
std::vector<Point> to_study(std::vector<Point> pixels) {
  for (Point& p : pixels) p.y = 100 - p.y;
  return pixels;
}

/// 50 gauges in a square of 100 whose rain grows by 4e-4 for each metre, with noise where asked.
ElevationFit fit_of(Seeded& seeded, double noise) {
  std::vector<Point> places;
  std::vector<double> elevations;
  std::vector<std::vector<double>> normals(2);
  for (int i = 0; i < 50; ++i) {
    places.push_back({seeded.uniform(0, 100), seeded.uniform(0, 100)});
    elevations.push_back(seeded.uniform(0, 3000));
    normals[0].push_back(50 * std::exp(4e-4 * elevations.back() + seeded.uniform(-noise, noise)));
    normals[1].push_back(70);
  }
  return {places, elevations, normals, Metric::planar, 1};
}

struct Row {
  std::vector<double> normals;
  std::vector<char> held;
};

/// The normals of pixels from one on; `spread` is the variance of their elevations.
Row row_from(const ElevationPatch& patch, double column, double row,
             const std::vector<double>& elevations, double spread = 0) {
  Row found{std::vector<double>(elevations.size() * patch.months()),
            std::vector<char>(elevations.size())};
  patch.fill({{column + 0.5, row + 0.5}, 1}, elevations,
             std::vector<double>(elevations.size(), spread), found.normals, found.held);
  return found;
}

TEST(ElevationLattices, tell_what_the_fit_tells_of_a_plain_truth) {
  Seeded seeded;
  const ElevationFit fit = fit_of(seeded, 0);
  ElevationLattice lattice(fit, to_study, 7, 5, 1);
  const ElevationPatch patch = lattice.over({10, 20}, 30, 20);
  const std::vector<double> elevations{0, 100, 500, 1000, 1500, 2000, 2500, none, 300, 1200, 900};
  for (const std::size_t row : {0u, 3u, 19u}) {
    const Row found = row_from(patch, 10, 20 + static_cast<double>(row), elevations);
    for (std::size_t c = 0; c < elevations.size(); ++c) {
      if (std::isnan(elevations[c])) {
        EXPECT_TRUE(std::isnan(found.normals[c]));
        continue;
      }
      if (found.held[c] == 0) {
        EXPECT_NEAR(found.normals[c], 50 * std::exp(4e-4 * elevations[c]), 1e-3);
      }
      EXPECT_NEAR(found.normals[elevations.size() + c], 70, 1e-6);
    }
  }
}

TEST(ElevationLattices, are_those_of_the_fit_at_their_nodes_and_bilinear_between) {
  Seeded seeded;
  const ElevationFit fit = fit_of(seeded, 0.3);
  ElevationLattice lattice(fit, to_study, 8, 8, 1);
  const ElevationPatch patch = lattice.over({40, 40}, 8, 8);
  // By hand: the centre of pixel 43, 45 lies at 3.5 / 8 and 5.5 / 8 between the nodes.
  const double along = 3.5 / 8;
  const double down = 5.5 / 8;
  double constant = 0;
  double slope = 0;
  double nearest = 0;
  std::vector<ToldNormal> told(2);
  for (const double i : {0.0, 1.0}) {
    for (const double j : {0.0, 1.0}) {
      fit.at({40 + 8 * i, 100 - (40 + 8 * j)}, told);
      const double share = (i == 0 ? 1 - along : along) * (j == 0 ? 1 - down : down);
      constant += share * told[0].line.constant;
      slope += share * told[0].line.slope;
      nearest += share * told[0].nearest;
    }
  }
  const Row found = row_from(patch, 40, 45, std::vector<double>(8, 1234));
  const double expected = std::exp(held_logarithm(constant + slope * 1234, nearest));
  EXPECT_NEAR(found.normals[3], expected, 1e-9 * expected);
  // 3.5 and 5.5 of 8: the nearest node is the lower left one of the pixel's four.
  fit.at({40, 100 - 48}, told);
  EXPECT_DOUBLE_EQ(patch.variance({43.5, 45.5}, 1234, 0), told[0].line.variance(1234));
}

TEST(ElevationLattices, do_not_depend_on_the_window) {
  Seeded seeded;
  const ElevationFit fit = fit_of(seeded, 0.3);
  ElevationLattice lattice(fit, to_study, 6, 9, 1);
  const std::vector<double> whole(60, 800);
  const std::vector<double> part(20, 800);
  const Row of_whole = row_from(lattice.over({-5, -7}, 60, 60), -5, 23, whole);
  const Row of_part = row_from(lattice.over({15, 13}, 20, 20), 15, 23, part);
  for (std::size_t c = 0; c < part.size(); ++c)
    EXPECT_NEAR(of_part.normals[c], of_whole.normals[c + 20], 1e-12 * of_part.normals[c]);
}

TEST(ElevationLattices, tell_the_mean_of_a_block_of_pixels) {
  // Half of the block lies 100 above its mean and half 100 below: the mean of exp(4e-4 z) is that
  // of the mean times cosh(0.04), of which 1 + 0.04 squared / 2 is all but 1e-7.
  Seeded seeded;
  const ElevationFit fit = fit_of(seeded, 0);
  ElevationLattice lattice(fit, to_study, 7, 5, 1);
  const ElevationPatch patch = lattice.over({10, 20}, 30, 20);
  const double mean = 50 * std::exp(4e-4 * 1500);
  EXPECT_NEAR(row_from(patch, 20, 30, {1500}, 100 * 100).normals[0], mean * std::cosh(0.04), 1e-3);
  // Values may lie farther apart than nodes.
  std::vector<double> normals(6);
  std::vector<char> held(3);
  patch.fill({{12, 22}, 9}, std::vector<double>{1500, 1500, 1500}, std::vector<double>(3), normals,
             held);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(normals[i], mean, 1e-3);
}

TEST(ElevationLattices, say_what_they_hold) {
  Seeded seeded;
  const ElevationFit fit = fit_of(seeded, 0);
  ElevationLattice lattice(fit, to_study, 4, 4, 1);
  // 4e-4 a metre: no gauge is below 0, and 30,000 m are e to the 12th of the sea's.
  const Row found = row_from(lattice.over({50, 50}, 2, 1), 50, 50, {30000, 1500});
  EXPECT_EQ(found.held[0], 1);
  EXPECT_LE(found.normals[0], 4 * 50 * std::exp(1.2));
}

TEST(ElevationLattices, have_nothing_where_positions_cannot_be_taken) {
  Seeded seeded;
  const ElevationFit fit = fit_of(seeded, 0);
  const auto ends = [](std::vector<Point> pixels) {
    for (Point& p : pixels) p = p.x > 50 ? Point{none, none} : to_study({p}).front();
    return pixels;
  };
  ElevationLattice lattice(fit, ends, 5, 5, 1);
  const Row found = row_from(lattice.over({40, 40}, 20, 1), 40, 40, std::vector<double>(20, 500));
  EXPECT_FALSE(std::isnan(found.normals[9]));
  EXPECT_TRUE(std::isnan(found.normals[10]));
  EXPECT_EQ(found.held[10], 0);
}

}  // namespace
}  // namespace thiessen

#include "earth/sphere/chord_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "earth/random_points.h"
#include "earth/sphere/geodesic.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double equatorial = 6378137;
constexpr double polar = 6356752.314245179;

double chord(Point a, Point b) {
  return length(on_ellipsoid(a) - on_ellipsoid(b));
}

/// The arc over a chord of a circle of the polar radius of curvature: no geodesic is shorter, and
/// on that least_certain_excess rests.
double shortest_over_chord(double chord) {
  constexpr double diameter = 2 * equatorial * equatorial / polar;
  return diameter * std::asin(std::min(1.0, chord / diameter));
}

TEST(ChordBounds, the_axes_end_on_the_ellipsoid) {
  EXPECT_DOUBLE_EQ(on_ellipsoid({0, 0}).x, equatorial);
  EXPECT_DOUBLE_EQ(on_ellipsoid({90, 0}).y, equatorial);
  EXPECT_DOUBLE_EQ(on_ellipsoid({-180, 0}).x, -equatorial);
  EXPECT_NEAR(on_ellipsoid({33, 90}).z, polar, 2e-9);
  EXPECT_NEAR(on_ellipsoid({33, -90}).z, -polar, 2e-9);
  EXPECT_EQ(on_ellipsoid({33, 90}).x, 0);
}

TEST(ChordBounds, below_a_point_is_where_it_came_from) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    const Point p = random_point(seeded);
    const Direction there = on_ellipsoid(p);
    const FootPoint foot = below(there);
    ASSERT_NEAR(geodesic_distance(foot.position, p), 0, 1e-8);
    ASSERT_LT(foot.height, 1e-8);
    ASSERT_NEAR(below((1 - 1000 / length(there)) * there).height, 1000, 0.02);
  }
}

TEST(ChordBounds, geodesics_lie_between) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    const Point p = random_point(seeded);
    const Point q = random_point_at(seeded, p, 2.0003e7 * std::pow(10, -seeded.uniform(0, 6)));
    const double distance = geodesic_distance(p, q);
    const double noise = 1e-8 + 1e-15 * distance;
    ASSERT_LE(shortest_over_chord(chord(p, q)), distance + noise);
    ASSERT_GE(longest_over_chord(chord(p, q)), distance - noise);
  }
}

// Across the equator the meridian's curvature is the largest there is, at a pole all are smallest.
TEST(ChordBounds, are_reached) {
  const Point south{0, -0.5};
  const Point north{0, 0.5};
  const double distance = geodesic_distance(south, north);
  EXPECT_NEAR(longest_over_chord(chord(south, north)), distance, 1e-4);
  const Point one_side{0, 89.5};
  const Point other_side{180, 89.5};
  EXPECT_NEAR(shortest_over_chord(chord(one_side, other_side)),
              geodesic_distance(one_side, other_side), 1e-4);
  EXPECT_GT(longest_over_chord(12.75e6), geodesic_distance({0, 90}, {0, -90}));
}

// Of two places that with more excess is the farther, however far both are.
TEST(ChordBounds, an_excess_tells_which_place_is_nearer) {
  Seeded seeded;
  std::uint64_t told = 0;
  std::uint64_t told_apiece = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(100000); ++round) {
    const Point p = random_point(seeded);
    const double far = 1.9e7 * std::pow(10, -seeded.uniform(0, 5));
    const Point first = random_point_at(seeded, p, far);
    const bool near = round % 2 == 0;
    const Point second =
        near ? random_point_at(seeded, first, far * std::pow(10, -seeded.uniform(1, 5)))
             : random_point_at(seeded, p, far * (1 + std::pow(10, -seeded.uniform(1, 10))));
    const double c = chord(p, first);
    const double other = chord(p, second);
    const double apart = chord(first, second);
    const double excess = other * other - c * c - 1e-7 * (c + other);
    const double longer = geodesic_distance(p, second) - geodesic_distance(p, first);
    if (excess > least_certain_excess(c)) {
      ++told;
      ASSERT_GT(longer, 0) << round;
    }
    if (near && apart <= c / 8 && excess > 2 * least_certain_excess_apiece(c) * apart) {
      ++told_apiece;
      ASSERT_GT(longer, 0) << round;
    }
  }
  EXPECT_GT(told, seeded.rounds(30000));
  EXPECT_GT(told_apiece, seeded.rounds(15000));
}

// At the equator, where chords to the north and to the east are wrong by two thirds of what they
// may be, half the excess is not enough.
TEST(ChordBounds, an_excess_is_not_much_larger_than_need_be) {
  for (const double metres : {1e4, 1e5, 1e6, 3e6}) {
    const Point p{0, -metres / 2 / 110574};
    const Point north = moved(p, 0, metres);
    const double c = chord(p, north);
    const double wanted = std::sqrt(c * c + 0.5 * least_certain_excess(c));
    const Point middle{0, 0};
    double low = metres * 0.99;
    double high = metres * 1.01;
    for (int i = 0; i < 60; ++i) {
      const double half = (low + high) / 2;
      (chord(middle, moved(middle, half, 0)) < wanted ? low : high) = half;
    }
    EXPECT_LT(high, metres) << metres;
  }
}

}  // namespace
}  // namespace thiessen

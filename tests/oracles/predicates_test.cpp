// The predicates against rational numbers and against CGAL's over the same. Sets of points that
// make each stage of the arithmetic decide: anywhere, near a line or a circle, ulps apart, and over
// the whole range of exactness.
#include "geometry/predicates.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "oracles/exact.h"

namespace thiessen {
namespace {

using exactly::position;
using exactly::Rational;
using Corners = std::array<Point, 4>;

using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;

Kernel::Point_2 cgal(Point p) {
  return {CGAL::Gmpq(p.x), CGAL::Gmpq(p.y)};
}

double at_scale(Seeded& seeded, int low, int high) {
  const double magnitude =
      std::ldexp(seeded.uniform(1, 2), static_cast<int>(seeded.whole(low, high)));
  return seeded.below(2) == 0 ? magnitude : -magnitude;
}

Point on_circle(Seeded& seeded, Point centre, double radius) {
  const double angle = seeded.uniform(0, 7);
  return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)};
}

Corners random_corners(Seeded& seeded) {
  Corners p;
  const auto family = seeded.below(11);
  const Point offset{at_scale(seeded, -10, 30), at_scale(seeded, -10, 30)};
  for (Point& q : p) {
    switch (family) {
      case 0:
        q = {seeded.uniform(-1, 1), seeded.uniform(-1, 1)};
        break;
      case 1:  // near a line
        q.x = seeded.uniform(-1, 1);
        q.y = seeded.near(0.7 * q.x, 2);
        break;
      case 2:  // near a circle
        q = on_circle(seeded, offset, 1);
        break;
      case 3:  // ulps apart
        q = {seeded.near(offset.x, 3), seeded.near(offset.y, 3)};
        break;
      case 4:  // a lattice in tenths
        q = {0.1 * static_cast<double>(seeded.whole(-5, 5)),
             0.1 * static_cast<double>(seeded.whole(-5, 5))};
        break;
      case 5:  // a lattice far out
        q = {500000 + 0.1 * static_cast<double>(seeded.whole(-5, 5)),
             4000000 + 0.1 * static_cast<double>(seeded.whole(-5, 5))};
        break;
      case 6: {  // on a line of whole numbers
        const auto t = static_cast<double>(seeded.whole(-1000, 1000));
        q = {500000 + t, 4000000 - 3 * t};
        break;
      }
      case 7: {  // on the circle of radius 25 in whole numbers
        q = std::array<Point, 5>{{{25, 0}, {24, 7}, {20, 15}, {15, 20}, {7, 24}}}.at(
            seeded.below(5));
        if (seeded.below(2) == 0) q.x = -q.x;
        if (seeded.below(2) == 0) q.y = -q.y;
        break;
      }
      case 8:  // a lattice of two scales
        q = {static_cast<double>(seeded.whole(-1, 1)),
             std::ldexp(static_cast<double>(seeded.whole(-1, 1)), -70)};
        break;
      case 9:  // the whole range
        q = {at_scale(seeded, -142, 200), at_scale(seeded, -142, 200)};
        break;
      default:  // its ends
        q = {seeded.below(2) == 0 ? at_scale(seeded, -142, -140) : at_scale(seeded, 198, 200),
             seeded.below(2) == 0 ? at_scale(seeded, -142, -140) : at_scale(seeded, 198, 200)};
    }
  }
  return p;
}

TEST(PredicatesAgainstRationals, orientation) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    const Rational area = exactly::doubled_area(position(a), position(b), position(c));
    ASSERT_EQ(orientation(a, b, c), area.sign());
    ASSERT_EQ(orientation(a, b, c), CGAL::orientation(cgal(a), cgal(b), cgal(c)));
  }
}

TEST(PredicatesAgainstRationals, in_circle) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    auto [a, b, c, d] = random_corners(seeded);
    if (orientation(a, b, c) < 0) std::swap(a, b);
    if (orientation(a, b, c) == 0) continue;
    const Rational lift = exactly::in_circle(position(a), position(b), position(c), position(d));
    ASSERT_EQ(in_circle(a, b, c, d), lift.sign());
    ASSERT_EQ(in_circle(a, b, c, d),
              CGAL::side_of_oriented_circle(cgal(a), cgal(b), cgal(c), cgal(d)));
  }
}

TEST(PredicatesAgainstRationals, compare_distance) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(100000); ++round) {
    const auto [from, a, b, d] = random_corners(seeded);
    const Rational difference = exactly::square_distance(position(from), position(a)) -
                                exactly::square_distance(position(from), position(b));
    ASSERT_EQ(compare_distance(from, a, b), difference.sign());
    ASSERT_EQ(compare_distance(from, a, b),
              CGAL::compare_distance_to_point(cgal(from), cgal(a), cgal(b)));
  }
}

TEST(PredicatesAgainstRationals, doubled_area_is_right_to_25_roundings) {
  Seeded seeded;
  double worst = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(100000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    const Rational area = exactly::doubled_area(position(a), position(b), position(c));
    if (area == 0) {
      ASSERT_EQ(doubled_area(a, b, c), 0);
      continue;
    }
    const Rational error = abs(Rational(doubled_area(a, b, c)) - area) / abs(area);
    worst = std::max(worst, error.convert_to<double>());
    ASSERT_LE(error, Rational(25 * 0x1p-53));
  }
  RecordProperty("worst_in_units_of_2^-53", std::to_string(worst * 0x1p53));
}

// Measured, in units of 2^-53 of the distance from the first point, beside the last rounding.
TEST(PredicatesAgainstRationals, circumcentre_is_right_to_2_to_the_minus_51) {
  Seeded seeded;
  double worst = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(50000); ++round) {
    const auto [a, b, c, d] = random_corners(seeded);
    if (orientation(a, b, c) == 0) continue;
    const auto centre = exactly::circumcentre(position(a), position(b), position(c));
    const Point computed = circumcentre(a, b, c);
    const Point first = std::min({a, b, c});
    for (const auto& [true_value, value, origin] :
         {std::tuple(centre.x, computed.x, first.x), std::tuple(centre.y, computed.y, first.y)}) {
      const Rational error = abs(Rational(value) - true_value);
      const Rational last_rounding = abs(true_value) * Rational(0x1.1p-53);
      const Rational away = abs(true_value - Rational(origin));
      ASSERT_LE(error, last_rounding + away * Rational(0x1p-51));
      if (error > last_rounding) {
        const Rational units = (error - last_rounding) / away;
        worst = std::max(worst, units.convert_to<double>());
      }
    }
  }
  RecordProperty("worst_in_units_of_2^-53", std::to_string(worst * 0x1p53));
}

// The predicate as it is defined: lifts of eps^k for the lexicographically k-th last of the four,
// with an eps small enough for these whole numbers.
TEST(PredicatesAgainstRationals, in_perturbed_circle_is_in_circle_with_lifted_points) {
  std::vector<Point> grid;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 5; ++y) grid.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  const Rational epsilon(0x1p-40);
  const auto inside = [&](const Corners& p) {
    Corners sorted = p;
    std::sort(sorted.begin(), sorted.end());
    std::array<Rational, 4> lift;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto rank = std::find(sorted.begin(), sorted.end(), p[i]) - sorted.begin();
      lift[i] = exactly::square_distance(position(Point{0, 0}), position(p[i]));
      Rational step = epsilon;
      for (auto k = rank; k < 3; ++k) step *= epsilon;
      lift[i] += step;
    }
    // The lifted d below the plane through the lifted a, b, c.
    const auto q = [&](std::size_t i) { return position(p[i]); };
    const Rational determinant = (lift[0] - lift[3]) * exactly::doubled_area(q(3), q(1), q(2)) +
                                 (lift[1] - lift[3]) * exactly::doubled_area(q(3), q(2), q(0)) +
                                 (lift[2] - lift[3]) * exactly::doubled_area(q(3), q(0), q(1));
    return determinant > 0;
  };
  Seeded seeded;
  int on_circle = 0;
  for (std::uint64_t round = 0; round < seeded.rounds(20000); ++round) {
    Corners p;
    std::sample(grid.begin(), grid.end(), p.begin(), 4, seeded.generator());
    std::shuffle(p.begin(), p.end(), seeded.generator());
    if (orientation(p[0], p[1], p[2]) < 0) std::swap(p[0], p[1]);
    if (orientation(p[0], p[1], p[2]) == 0) continue;
    on_circle += in_circle(p[0], p[1], p[2], p[3]) == 0;
    ASSERT_EQ(in_perturbed_circle(p[0], p[1], p[2], p[3]), inside(p));
  }
  EXPECT_GT(on_circle, 500);
}

}  // namespace
}  // namespace thiessen

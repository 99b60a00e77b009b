#include "earth/area/ellipsoid_area.h"

#include <gtest/gtest.h>

#include <cmath>

#include "earth/area/earth_area.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

Point somewhere(Seeded& seeded) {
  return {seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
}

TEST(AreaUnder, law_1_changes_its_sign_alone_with_the_direction) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const Point a = somewhere(seeded), b = somewhere(seeded);
    const double reference = seeded.uniform(-90, 90);
    ASSERT_EQ(area_under(b, a, reference), -area_under(a, b, reference));
  }
}

TEST(AreaUnder, law_2_summed_round_a_ring_does_not_depend_on_the_reference) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    const Point a = somewhere(seeded), b = somewhere(seeded), c = somewhere(seeded);
    const auto sum = [&](double reference) {
      return area_under(a, b, reference) + area_under(b, c, reference) +
             area_under(c, a, reference);
    };
    ASSERT_NEAR(sum(seeded.uniform(-90, 90)), sum(seeded.uniform(-90, 90)), 1e-13 * earth_area);
  }
}

TEST(AreaUnder, of_a_part_and_the_rest_is_that_of_the_whole) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    const Point a = somewhere(seeded), b = somewhere(seeded);
    const double t = seeded.uniform(0, 1);
    const Point middle{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    const double reference = seeded.uniform(-90, 90);
    ASSERT_NEAR(area_under(a, middle, reference) + area_under(middle, b, reference),
                area_under(a, b, reference), 1e-13 * earth_area);
  }
}

TEST(AreaUnder, of_a_meridian_is_nothing) {
  EXPECT_EQ(area_under({10, -20}, {10, 70}, 5), 0);
}

TEST(AreaUnder, of_the_equator_above_the_south_pole_is_half_the_earth) {
  EXPECT_NEAR(area_under({-180, 0}, {180, 0}, -90) / earth_area, 0.5, 1e-15);
  EXPECT_NEAR(area_under({-180, 90}, {180, 90}, -90) / earth_area, 1, 1e-15);
}

// A strip between parallels by the closed formula, in
// long doubles (Map projections: a working manual, 1987, equation 3-12).
TEST(AreaUnder, of_a_parallel_is_the_closed_formula) {
  const long double a = 6378137;
  const long double f = 1 / 298.257223563L;
  const long double e = std::sqrt(f * (2 - f));
  const auto authalic = [&](double degrees) {
    const long double s = std::sin(degrees * M_PIl / 180);
    return s / (1 - e * e * s * s) + std::atanh(e * s) / e;
  };
  for (double latitude = -89.5; latitude < 90; latitude += 0.5) {
    const long double expected =
        a * a * (1 - e * e) / 2 * (authalic(latitude) - authalic(30)) * (7 * M_PIl / 180);
    EXPECT_NEAR(area_under({3, latitude}, {10, latitude}, 30), static_cast<double>(expected), 0.05);
  }
}

// The curve is a parabola in longitude and latitude, up to 30 km long and bent by up to a
// kilometre; its area is that of very many chords.
TEST(AreaBesideChord, is_that_of_many_short_chords) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(300); ++round) {
    const Point start{seeded.uniform(-180, 180), seeded.uniform(-75, 75)};
    const double length = std::pow(10, seeded.uniform(-3, -0.6));
    const double angle = seeded.uniform(0, 6.28);
    const double bend = 0.03 * length * seeded.uniform(-1, 1);
    const Point way{length * std::cos(angle), length * std::sin(angle)};
    const auto at = [&](double t) {
      const double off = 4 * bend * t * (1 - t) / length;
      return Point{start.x + t * way.x - off * way.y, start.y + t * way.y + off * way.x};
    };
    double area = area_under(start, at(1), start.y);
    constexpr int chords = 1000;
    for (int i = 0; i < chords; ++i)
      area -= area_under(at(static_cast<double>(i) / chords), at((i + 1.0) / chords), start.y);
    const double found = area_beside_chord(start, at(0.5), at(1));
    ASSERT_NEAR(found, area, 5e-4 * std::abs(area)) << length;
    const Point turned{at(1).x - 360, at(1).y};
    ASSERT_NEAR(area_beside_chord(start, at(0.5), turned), found, 1e-7 * std::abs(found));
    ASSERT_NEAR(area_beside_chord(at(1), at(0.5), start), -found, 1e-7 * std::abs(found));
  }
}

// A hundredth of a radian each way.
TEST(SquareRadian, is_that_of_a_small_square) {
  const double side = 0.01 * 180 / M_PI;
  for (double latitude = -80; latitude <= 80; latitude += 20) {
    const Point west{10, latitude + side / 2}, east{10 + side, latitude + side / 2};
    const double phi = latitude * M_PI / 180;
    const double whole = square_radian(std::sin(phi), std::cos(phi));
    EXPECT_NEAR(area_under(west, east, latitude - side / 2), 1e-4 * whole, 1e-9 * whole);
  }
}

}  // namespace
}  // namespace thiessen

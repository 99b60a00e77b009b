#include "earth/sphere/conformal_sphere.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "geometry/predicates.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

Direction random_direction(Seeded& seeded) {
  return unit({seeded.uniform(-1, 1), seeded.uniform(-1, 1), seeded.uniform(-1, 1)});
}

TEST(ConformalSphere, keeps_poles_and_the_equator) {
  EXPECT_EQ(on_sphere({77, 90}).z, 1);
  EXPECT_EQ(on_sphere({77, -90}).z, -1);
  EXPECT_EQ(on_sphere({0, 0}).x, 1);
  EXPECT_EQ(on_sphere({90, 0}).y, 1);
  EXPECT_EQ(on_sphere({180, 0}).x, -1);
  EXPECT_EQ(on_sphere({180, 7}).x, on_sphere({-180, 7}).x);
}

TEST(ConformalSphere, comes_back) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const Point p{seeded.uniform(-180, 180), seeded.uniform(-90, 90)};
    const Point back = from_sphere(on_sphere(p));
    ASSERT_NEAR(back.y, p.y, 1e-13);
    ASSERT_NEAR(std::remainder(back.x - p.x, 360) * std::cos(p.y * M_PI / 180), 0, 1e-13);
    ASSERT_NEAR(length(on_sphere(p)), 1, 1e-15);
  }
}

// J. P. Snyder, Map projections: a working manual, 1987, equation 3-1, in long doubles.
TEST(ConformalSphere, has_snyder_s_conformal_latitudes) {
  const long double f = 1 / 298.257223563L;
  const long double e = std::sqrt(f * (2 - f));
  for (double latitude = -89; latitude < 90; latitude += 0.5) {
    const long double phi = latitude * M_PIl / 180;
    const long double s = e * std::sin(phi);
    const long double chi =
        2 * std::atan(std::tan(M_PIl / 4 + phi / 2) * std::pow((1 - s) / (1 + s), e / 2)) -
        M_PIl / 2;
    EXPECT_NEAR(on_sphere({0, latitude}).z, static_cast<double>(std::sin(chi)), 1e-15);
  }
}

TEST(ConformalSphere, has_the_sine_of_the_latitude_from_that_of_the_conformal_one) {
  for (double latitude = -90; latitude <= 90; latitude += 0.5)
    EXPECT_NEAR(sine_of_latitude(on_sphere({0, latitude}).z), std::sin(latitude * M_PI / 180),
                3e-8);
}

TEST(ConformalSphere, is_conformal) {
  // A small step north and one east of equal length on the ellipsoid are of equal length there.
  const double f = 1 / 298.257223563;
  const double e2 = f * (2 - f);
  for (double latitude = -80; latitude <= 80; latitude += 10) {
    const double phi = latitude * M_PI / 180;
    const double w2 = 1 - e2 * std::sin(phi) * std::sin(phi);
    const double north_per_degree = (1 - e2) / (w2 * std::sqrt(w2));
    const double east_per_degree = std::cos(phi) / std::sqrt(w2);
    const double step = 1e-4;
    const double north = length(on_sphere({0, latitude + step}) - on_sphere({0, latitude - step}));
    const double east = length(on_sphere({step, latitude}) - on_sphere({-step, latitude}));
    EXPECT_NEAR(north / north_per_degree / (east / east_per_degree), 1, 1e-8);
  }
}

// However short: a chord from one side of a point to the other is in proportion to its length, but
// for a share of the order of the length's square. The coordinates are such that no sum rounds.
TEST(ChordOnSphere, is_right_to_its_own_length_however_short) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(500); ++round) {
    const auto degrees = [&](std::int64_t most) {
      return static_cast<double>(seeded.whole(-most * 256, most * 256)) / 256;
    };
    const Point p{degrees(180), degrees(85)};
    const Point way{degrees(1), degrees(1)};
    const auto chord = [&](double share) {
      const Point half{share * way.x, share * way.y};
      return (1 / share) *
             chord_on_sphere({p.x - half.x, p.y - half.y}, {p.x + half.x, p.y + half.y});
    };
    const Direction expected = chord(0x1p-20);
    for (const double share : {0x1p-22, 0x1p-26, 0x1p-30})
      ASSERT_LE(length(chord(share) - expected), 1e-12 * length(expected));
    // Where the plain difference is well known, they agree.
    const Direction plain = on_sphere({p.x + way.x, p.y + way.y}) - on_sphere(p);
    const Direction found = chord_on_sphere(p, {p.x + way.x + 720, p.y + way.y});
    ASSERT_LE(length(found - plain), 1e-15);
  }
}

TEST(Axes, are_tangents_to_the_east_and_to_the_north) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(500); ++round) {
    const Point p{seeded.uniform(-180, 180), seeded.uniform(-89, 89)};
    const Direction at = on_sphere(p);
    const auto [east, north] = axes_at(at);
    for (const Direction axis : {east, north}) {
      ASSERT_NEAR(length(axis), 1, 1e-14);
      ASSERT_NEAR(dot(axis, at), 0, 1e-15);
    }
    ASSERT_NEAR(dot(unit(chord_on_sphere(p, {p.x + 1e-6, p.y})), east), 1, 1e-12);
    ASSERT_NEAR(dot(unit(chord_on_sphere(p, {p.x, p.y + 1e-6})), north), 1, 1e-12);
    const Tangent tangent = tangent_at(at, 3 * east + -4 * north + 7 * at);
    ASSERT_NEAR(tangent.east, 3, 1e-13);
    ASSERT_NEAR(tangent.north, -4, 1e-13);
  }
}

// The sphere's own predicate: d is on the side of the plane through a, b, c that holds the cap.
TEST(StereographicChart, keeps_circles) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5000); ++round) {
    const StereographicChart chart(random_direction(seeded));
    const Direction a = random_direction(seeded), b = random_direction(seeded);
    const Direction c = random_direction(seeded), d = random_direction(seeded);
    const std::array<Point, 4> p{chart.project(a), chart.project(b), chart.project(c),
                                 chart.project(d)};
    const double volume = dot(cross(b - a, c - a), d - a);
    if (std::abs(volume) < 1e-6) continue;
    const int turn = orientation(p[0], p[1], p[2]);
    const int inside =
        turn > 0 ? in_circle(p[0], p[1], p[2], p[3]) : -in_circle(p[1], p[0], p[2], p[3]);
    ASSERT_EQ(inside, volume > 0 ? 1 : -1);
  }
}

TEST(StereographicChart, law_unproject_is_the_inverse_of_project) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(1000); ++round) {
    const StereographicChart chart(random_direction(seeded));
    const Direction p = random_direction(seeded);
    const Direction again = chart.unproject(chart.project(p));
    ASSERT_NEAR(length(again - p), 0, 1e-14);
  }
}

TEST(StereographicChart, knows_its_pole) {
  const Direction pole = on_sphere({12, 34});
  EXPECT_TRUE(StereographicChart(pole).is_pole(pole));
  EXPECT_FALSE(StereographicChart(pole).is_pole(on_sphere({12, 34.0000001})));
}

}  // namespace
}  // namespace thiessen

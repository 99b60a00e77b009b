#include "earth/sphere/geodesic_chords.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "earth/sphere/geodesic.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

double short_way(double difference) {
  return std::remainder(difference, 360);
}

/// The ends and the bends between them.
std::vector<Point> whole(Point a, Point b, double tolerance) {
  std::vector<Point> points{a};
  const std::vector<Point> bends = geodesic_chords(a, b, tolerance);
  points.insert(points.end(), bends.begin(), bends.end());
  points.push_back(b);
  return points;
}

/// A point on the geodesic lies on the way: the distances from both ends add up to the whole. So
/// far off it they add up to more: by d^2 / 2 times what its distances from the ends say.
double metres_off(Point a, Point b, Point p) {
  const double from = geodesic_distance(a, p);
  const double to = geodesic_distance(p, b);
  const double more = std::max(0.0, from + to - geodesic_distance(a, b));
  return std::sqrt(2 * more * from * to / (from + to));
}

TEST(GeodesicChords, law_1_the_way_back_is_the_same) {
  Seeded seeded;
  for (int i = 0; i < 100; ++i) {
    const Point a{seeded.uniform(-180, 180), seeded.uniform(-89, 89)};
    const Point b{seeded.uniform(-180, 180), seeded.uniform(-89, 89)};
    std::vector<Point> back = geodesic_chords(b, a, 10);
    std::reverse(back.begin(), back.end());
    EXPECT_EQ(geodesic_chords(a, b, 10), back);
  }
}

TEST(GeodesicChords, law_2_chords_lie_within_the_tolerance) {
  Seeded seeded;
  for (int i = 0; i < 100; ++i) {
    const Point a{seeded.uniform(-180, 180), seeded.uniform(-80, 80)};
    const Point b{a.x + seeded.uniform(-20, 20),
                  std::clamp(a.y + seeded.uniform(-9, 9), -80.0, 80.0)};
    const Point end{short_way(b.x), b.y};
    const std::vector<Point> points = whole(a, end, 100);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      for (const double share : {0.2, 0.5, 0.9}) {
        const Point on{points[k].x + share * short_way(points[k + 1].x - points[k].x),
                       points[k].y + share * (points[k + 1].y - points[k].y)};
        EXPECT_LE(metres_off(a, end, on), 110) << a.x << ' ' << a.y << ' ' << b.x << ' ' << b.y;
      }
    }
  }
}

TEST(GeodesicChords, along_a_meridian_has_no_bends) {
  EXPECT_TRUE(geodesic_chords({10, -40}, {10, 60}, 0.1).empty());
  EXPECT_TRUE(geodesic_chords({10, 50}, {-70, 90}, 0.1).empty()) << "nor to a pole";
}

TEST(GeodesicChords, over_a_pole_stands_there_twice) {
  EXPECT_EQ(geodesic_chords({-100, 70}, {80, 60}, 0.1), (std::vector<Point>{{-100, 90}, {80, 90}}));
  EXPECT_EQ(geodesic_chords({-100, -70}, {80, -60}, 0.1),
            (std::vector<Point>{{-100, -90}, {80, -90}}));
}

TEST(GeodesicChords, over_the_antimeridian_stay_within_180_degrees) {
  const std::vector<Point> bends = geodesic_chords({170, 40}, {-170, 45}, 0.1);
  ASSERT_GT(bends.size(), 10U);
  for (const Point bend : bends) EXPECT_LE(std::abs(bend.x), 180);
}

}  // namespace
}  // namespace thiessen

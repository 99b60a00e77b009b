// Judged by looking at each place, for points all over the ground.
#include "diagram/needed_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/box.h"
#include "tessellation/families.h"

namespace thiessen {
namespace {

Ring rectangle(Point low, Point high) {
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

std::vector<Point> random_places(Seeded& seeded, std::size_t count) {
  std::vector<Point> places(count);
  for (Point& p : places) p = {seeded.uniform(0, 1), seeded.uniform(0, 1)};
  return places;
}

std::size_t nearest(const std::vector<Point>& places, Point to) {
  const auto away = [&](Point p) { return std::hypot(p.x - to.x, p.y - to.y); };
  const auto found = std::min_element(places.begin(), places.end(),
                                      [&](Point p, Point q) { return away(p) < away(q); });
  return static_cast<std::size_t>(found - places.begin());
}

/// Points in and on a triangle, corners included.
std::vector<Point> points_of(Seeded& seeded, const Ring& triangle) {
  std::vector<Point> points = triangle;
  for (int i = 0; i < 60; ++i) {
    double u = seeded.uniform(0, 1);
    double v = i % 3 == 0 ? 0 : seeded.uniform(0, 1);  // some along an edge
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Point o = triangle[0];
    points.push_back({o.x + u * (triangle[1].x - o.x) + v * (triangle[2].x - o.x),
                      o.y + u * (triangle[1].y - o.y) + v * (triangle[2].y - o.y)});
  }
  return points;
}

TEST(NeededPlaces, law_1_the_nearest_to_any_point_of_the_ground_is_one) {
  Seeded seeded;
  for (const Family& family : families::all(seeded, 700)) {
    SCOPED_TRACE(family.name);
    Box box;
    for (const Point p : family.points) box.take_in(p);
    for (int round = 0; round < 12; ++round) {
      const double size = std::pow(10, seeded.uniform(-3, -0.5));
      const Point about{box.low.x + seeded.uniform(-0.1, 1.1) * box.width(),
                        box.low.y + seeded.uniform(-0.1, 1.1) * box.height()};
      const auto corner = [&] {
        return Point{about.x + size * box.width() * seeded.uniform(-1, 1),
                     about.y + size * box.height() * seeded.uniform(-1, 1)};
      };
      const MultiPolygon shape{{{corner(), corner(), corner()}, {}}};
      const std::vector<const MultiPolygon*> ground{&shape};
      const std::vector<bool> is_needed = needed_places(family.points, ground);
      if (is_needed.empty()) continue;
      ASSERT_EQ(is_needed.size(), family.points.size());
      for (const Point p : points_of(seeded, shape[0].outer))
        ASSERT_TRUE(is_needed[nearest(family.points, p)]);
    }
  }
}

TEST(NeededPlaces, are_few_for_little_ground) {
  Seeded seeded;
  const std::vector<Point> places = random_places(seeded, 10'000);
  const MultiPolygon shape{{rectangle({0.2, 0.3}, {0.3, 0.4}), {}}};
  const std::vector<const MultiPolygon*> ground{&shape};
  const std::vector<bool> is_needed = needed_places(places, ground);
  ASSERT_EQ(is_needed.size(), places.size());
  // The ground is 0.1 wide, and three squares of 0.02 on either side of it: 484 places and so many
  // as chance adds.
  EXPECT_LT(std::count(is_needed.begin(), is_needed.end(), true), 600);
  EXPECT_GT(std::count(is_needed.begin(), is_needed.end(), true), 80);
}

TEST(NeededPlaces, lie_round_holes_and_not_in_their_middle) {
  Seeded seeded;
  std::vector<Point> places = random_places(seeded, 10'000);
  places.push_back({0.5, 0.5});
  places.push_back({0.1, 0.5});
  Ring hole = rectangle({0.2, 0.2}, {0.8, 0.8});
  std::reverse(hole.begin(), hole.end());
  const MultiPolygon shape{{rectangle({0, 0}, {1, 1}), {hole}}};
  const std::vector<const MultiPolygon*> ground{&shape};
  const std::vector<bool> is_needed = needed_places(places, ground);
  ASSERT_EQ(is_needed.size(), places.size());
  EXPECT_FALSE(is_needed[10'000]);
  EXPECT_TRUE(is_needed[10'001]);
}

// A lone place is the nearest to ground that is far from all.
TEST(NeededPlaces, may_be_far_from_the_ground) {
  Seeded seeded;
  std::vector<Point> places = random_places(seeded, 2'000);
  places.push_back({40, 0});
  const MultiPolygon shape{{rectangle({80, 0}, {81, 1}), {}}};
  const std::vector<const MultiPolygon*> ground{&shape};
  const std::vector<bool> is_needed = needed_places(places, ground);
  ASSERT_EQ(is_needed.size(), places.size());
  EXPECT_TRUE(is_needed.back());
}

TEST(NeededPlaces, are_not_told_where_all_are) {
  Seeded seeded;
  const MultiPolygon all{{rectangle({0, 0}, {1, 1}), {}}};
  const std::vector<const MultiPolygon*> ground{&all};
  EXPECT_TRUE(needed_places(random_places(seeded, 10'000), ground).empty());
  EXPECT_TRUE(needed_places(random_places(seeded, 10'000), {}).empty());
  EXPECT_TRUE(needed_places(random_places(seeded, 20), ground).empty());
}

}  // namespace
}  // namespace thiessen

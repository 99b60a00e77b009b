// Whether points lie in basins: beside every ring looked at by itself.
#include "basin/containment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "basin/shapes.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

/// In a part and in none of its holes, or on an edge.
bool holds(const Basin& basin, Point p) {
  return std::any_of(basin.shape.begin(), basin.shape.end(), [&](const Polygon& part) {
    if (locate(part.outer, p) != Where::inside) return locate(part.outer, p) == Where::boundary;
    return std::none_of(part.holes.begin(), part.holes.end(),
                        [&](const Ring& hole) { return locate(hole, p) == Where::inside; });
  });
}

TEST(Containment, law_1_is_that_of_every_part_without_its_holes) {
  Seeded seeded;
  const Basin basin = shapes::basin(shapes::islands(seeded, {0, 0}, 2, 4));
  const Containment containment(basin);
  std::size_t inside = 0;
  for (int i = 0; i < 3000; ++i) {
    const Point p{seeded.uniform(-1, 9), seeded.uniform(-1, 9)};
    EXPECT_EQ(containment.contains(p), holds(basin, p)) << p.x << ' ' << p.y;
    inside += containment.contains(p) ? 1u : 0u;
  }
  EXPECT_GT(inside, 100u);
}

TEST(Containment, law_2_holds_the_edges_also_those_of_holes) {
  const Ring hole = shapes::reversed(shapes::rectangle({1, 1}, {3, 3}));
  const Containment containment(shapes::basin({{shapes::rectangle({0, 0}, {4, 4}), {hole}}}));
  for (const Point p : {Point{0, 0}, {4, 4}, {2, 0}, {0, 3}, {1, 1}, {2, 3}, {1, 2}, {0.5, 1}})
    EXPECT_TRUE(containment.contains(p)) << p.x << ' ' << p.y;
  for (const Point p : {Point{2, 2}, {-1, 0}, {5, 0}, {4.5, 1}, {2, -0.1}, {1.1, 1.1}})
    EXPECT_FALSE(containment.contains(p)) << p.x << ' ' << p.y;
}

TEST(PointsWithin, law_1_are_for_each_basin_those_that_it_holds_in_rising_order) {
  Seeded seeded;
  std::vector<Basin> basins;
  for (int i = 0; i < 6; ++i) {
    const Point centre{seeded.uniform(0, 5), seeded.uniform(0, 5)};
    basins.push_back(shapes::basin({{shapes::star(seeded, centre, 2, 15), {}}}));
  }
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) points.push_back({seeded.uniform(-1, 6), seeded.uniform(-1, 6)});
  const auto within = points_within(basins, points, 0);
  const auto counts = count_within(basins, points, 0);
  ASSERT_EQ(within.size(), basins.size());
  for (std::size_t b = 0; b < basins.size(); ++b) {
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (holds(basins[b], points[i])) expected.push_back(i);
    }
    EXPECT_EQ(within[b], expected);
    EXPECT_EQ(counts[b], expected.size());
  }
}

TEST(PointsWithin, law_2_with_a_period_a_point_counts_once_wherever_the_basin_is_drawn) {
  const std::vector<Point> points{{-175, 1}, {175, 1}, {180, 0}, {0, 0}};
  for (const double turn : {-360.0, 0.0}) {
    const Basin basin = shapes::basin({{shapes::rectangle({170 + turn, -5}, {190 + turn, 5}), {}}});
    const std::vector<std::size_t> expected{0, 1, 2};
    EXPECT_EQ(points_within({basin}, points, 360)[0], expected) << turn;
  }
  const Basin world = shapes::basin({{shapes::rectangle({-180, -90}, {180, 90}), {}}});
  EXPECT_EQ(count_within({world}, points, 360)[0], 4u);
  EXPECT_EQ(
      points_within({shapes::basin({{shapes::rectangle({170, -5}, {190, 5}), {}}})}, points, 0)[0],
      (std::vector<std::size_t>{1, 2}));
}

}  // namespace
}  // namespace thiessen

#include "map/sheet/map_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace thiessen {
namespace {

TEST(MapShape, edges_follow_their_curve_alike_in_both_directions) {
  const MapProjection project = MapProjection::stereographic({0, 50});
  const LongitudeWindow window{-30, 60};
  const double tolerance = 1e-4;
  const MultiPolygon forth{{{{-30, 60}, {30, 60}, {0, 40}}, {}}};
  const MultiPolygon back{{{{30, 60}, {-30, 60}, {0, 80}}, {}}};
  const MapShape a = map_shape(forth, project, window, tolerance);
  const MapShape b = map_shape(back, project, window, tolerance);
  const auto along_sixty = [](const MapShape& shape) {
    std::vector<Point> points;
    for (const Point p : shape[0].rings[0]) points.push_back(p);
    std::sort(points.begin(), points.end());
    return points;
  };
  std::vector<Point> shared;
  const auto p = along_sixty(a);
  const auto q = along_sixty(b);
  std::set_intersection(p.begin(), p.end(), q.begin(), q.end(), std::back_inserter(shared));
  // The parallel bends by r (1 - cos(angle)): more points than its ends are needed, and all shared.
  EXPECT_GT(shared.size(), 10u);
  for (int lon = -30; lon <= 30; ++lon) {
    const Point exact = project({1.0 * lon, 60});
    double nearest = 1;
    for (std::size_t i = 1; i < shared.size(); ++i) {
      const double t = (exact.x - shared[i - 1].x) / (shared[i].x - shared[i - 1].x);
      if (t < 0 || t > 1) continue;
      const double y = shared[i - 1].y + t * (shared[i].y - shared[i - 1].y);
      nearest = std::min(nearest, std::abs(y - exact.y));
    }
    EXPECT_LT(nearest, 2 * tolerance) << "at longitude " << lon;
  }
}

TEST(MapShape, a_cut_along_the_antimeridian_is_no_outline) {
  const MultiPolygon cut{{{{170, -20}, {180, -20}, {180, -10}, {170, -10}}, {}},
                         {{{-180, -20}, {-170, -20}, {-170, -10}, {-180, -10}}, {}}};
  const MapProjection project = MapProjection::stereographic({180, -15});
  const MapShape shape = map_shape(cut, project, {170, 20}, 1e-3);
  const double middle = project({180, -15}).x;
  for (const MapPart& part : shape) {
    for (const auto& line : part.lines) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        const bool along_cut =
            std::abs(line[i].x - middle) < 1e-9 && std::abs(line[i - 1].x - middle) < 1e-9;
        EXPECT_FALSE(along_cut);
      }
    }
  }
  ASSERT_EQ(shape.size(), 2u);
  const auto by_x = [](Point a, Point b) { return a.x < b.x; };
  const Ring& west = shape[0].rings[0];
  const Ring& east = shape[1].rings[0];
  EXPECT_NEAR(std::max_element(west.begin(), west.end(), by_x)->x, middle, 1e-12);
  EXPECT_NEAR(std::min_element(east.begin(), east.end(), by_x)->x, middle, 1e-12);
}

TEST(MapShape, of_a_plane_is_as_it_was_but_for_the_origin) {
  const MultiPolygon shape{{{{10, 20}, {14, 20}, {14, 24}}, {{{12, 21}, {13, 21}, {13, 22}}}},
                           {{{0, 0}, {1, 0}, {0, 1}}, {}}};
  const MapShape seen = map_shape(shape, MapProjection::plane({10, 20}, 1), {}, 1e-3);
  ASSERT_EQ(seen.size(), 2u);
  ASSERT_EQ(seen[0].rings.size(), 2u);
  EXPECT_EQ(seen[0].rings[0], (Ring{{0, 0}, {4, 0}, {4, 4}}));
  EXPECT_EQ(seen[0].rings[1], (Ring{{2, 1}, {3, 1}, {3, 2}}));
  ASSERT_EQ(seen[0].lines.size(), 2u) << "a closed line for each ring";
  EXPECT_EQ(seen[0].lines[0], (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 0}}));
  EXPECT_EQ(seen[1].rings[0], (Ring{{-10, -20}, {-9, -20}, {-10, -19}}));
}

TEST(MapShape, an_edge_along_a_pole_is_no_outline) {
  const MultiPolygon cap{{{{-180, 60}, {-60, 60}, {60, 60}, {180, 60}, {180, 90}, {-180, 90}}, {}}};
  const MapProjection project = MapProjection::plate_carree({}, 60);
  for (const MapPart& part : map_shape(cap, project, {}, 1e-3)) {
    for (const auto& line : part.lines) {
      for (std::size_t i = 1; i < line.size(); ++i)
        EXPECT_FALSE(line[i].y == project({0, 90}).y && line[i - 1].y == line[i].y);
    }
  }
}

TEST(MapShape, of_all_of_the_earth_has_no_line_and_of_a_part_it_has) {
  const MapProjection project = MapProjection::plate_carree({}, 0);
  const MultiPolygon earth{{{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}}, {}}};
  const MultiPolygon part{{{{-20, -9}, {20, -9}, {20, 9}, {-20, 9}}, {}}};
  const MapShape whole = map_shape(earth, project, {}, 1e-3);
  EXPECT_FALSE(has_lines({}));
  EXPECT_FALSE(has_lines({whole}));
  EXPECT_TRUE(has_lines({whole, map_shape(part, project, {}, 1e-3)}));
}

TEST(MapShape, is_repeated_where_the_map_repeats_and_it_reaches_over_its_edge) {
  const MapProjection project = MapProjection::plate_carree({}, 0);
  const auto parts = [&](double west, double east) {
    const MultiPolygon strip{{{{west, 0}, {east, 0}, {east, 9}, {west, 9}}, {}}};
    return map_shape(strip, project, {}, 1e-3);
  };
  EXPECT_EQ(parts(-20, 20).size(), 1u);
  const MapShape over = parts(170, 190);
  ASSERT_EQ(over.size(), 2u);
  EXPECT_NEAR(std::abs(over[0].rings[0][0].x - over[1].rings[0][0].x), project.period(), 1e-12);
}

TEST(Extent, grows_to_hold_what_is_added) {
  Extent extent;
  EXPECT_TRUE(extent.empty());
  extent.add({3, -2});
  EXPECT_FALSE(extent.empty());
  EXPECT_EQ(extent.width(), 0);
  extent.add({1, 5});
  extent.add({2, 0});
  EXPECT_EQ(extent.west, 1);
  EXPECT_EQ(extent.east, 3);
  EXPECT_EQ(extent.height(), 7);
}

}  // namespace
}  // namespace thiessen

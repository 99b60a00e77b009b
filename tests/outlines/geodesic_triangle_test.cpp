#include "outlines/geodesic_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "earth/area/earth_area.h"
#include "earth/area/ellipsoid_area.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

/// Square metres inside a shape's chords.
double area_of(const MultiPolygon& shape) {
  double area = 0;
  for (const Polygon& polygon : shape) {
    const Ring& ring = polygon.outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
      area -= area_under(ring[i], ring[(i + 1) % ring.size()], 0);
  }
  return area;
}

TEST(GeodesicTriangle, an_octant_is_an_eighth_of_the_earth) {
  for (const double pole : {90.0, -90.0}) {
    for (int turn = 0; turn < 4; ++turn) {
      const auto at = [&](int k) { return Point{std::remainder(10.0 + 90 * k, 360), 0}; };
      const std::array<Point, 3> corners =
          pole > 0 ? std::array<Point, 3>{at(turn), at(turn + 1), Point{77, pole}}
                   : std::array<Point, 3>{at(turn + 1), at(turn), Point{77, pole}};
      const MultiPolygon shape = geodesic_triangle(corners, 1);
      EXPECT_EQ(validity_fault(shape), "");
      EXPECT_NEAR(area_of(shape) / earth_area, 0.125, 1e-12) << turn << ' ' << pole;
    }
  }
}

// Of two triangles that are each other's mirror image, one holds each pole.
TEST(GeodesicTriangle, round_a_pole_runs_along_it) {
  const MultiPolygon north = geodesic_triangle({{{0, 60}, {120, 60}, {-120, 60}}}, 1);
  const MultiPolygon south = geodesic_triangle({{{0, -60}, {-120, -60}, {120, -60}}}, 1);
  EXPECT_EQ(validity_fault(north), "");
  EXPECT_GT(area_of(north), 0);
  EXPECT_NEAR(area_of(north), area_of(south), 1);
  const auto holds = [](const MultiPolygon& shape, Point p) {
    return std::any_of(shape.begin(), shape.end(), [&](const Polygon& polygon) {
      return std::find(polygon.outer.begin(), polygon.outer.end(), p) != polygon.outer.end();
    });
  };
  EXPECT_TRUE(holds(north, {180, 90}));
  EXPECT_TRUE(holds(south, {-180, -90}));
}

// Corners far from the pole, on the other half of the Earth: it is inside all the same.
TEST(GeodesicTriangle, holds_the_pole_that_is_to_the_left_of_its_sides) {
  const MultiPolygon shape = geodesic_triangle({{{0, -5}, {120, -5}, {-120, -5}}}, 10);
  EXPECT_EQ(validity_fault(shape), "");
  EXPECT_GT(area_of(shape), 0.5 * earth_area);
}

TEST(GeodesicTriangle, is_cut_at_the_antimeridian) {
  const MultiPolygon shape = geodesic_triangle({{{170, 0}, {-170, 0}, {180, 10}}}, 1);
  ASSERT_EQ(shape.size(), 2U);
  EXPECT_EQ(validity_fault(shape), "");
  for (const Polygon& polygon : shape) {
    for (const Point p : polygon.outer) EXPECT_LE(std::abs(p.x), 180);
  }
}

TEST(GeodesicTriangle, is_empty_where_its_corners_are_on_one_geodesic) {
  EXPECT_TRUE(geodesic_triangle({{{10, 0}, {10, 1}, {10, 2}}}, 1).empty());
}

// A side over a pole: the half of the world between a meridian and the one across from it, cut.
TEST(GeodesicTriangle, may_have_a_side_over_a_pole) {
  const MultiPolygon west = geodesic_triangle({{{0, 60}, {180, 60}, {-90, 50}}}, 1);
  const MultiPolygon east = geodesic_triangle({{{180, 60}, {0, 60}, {90, 50}}}, 1);
  EXPECT_EQ(validity_fault(west), "");
  EXPECT_EQ(validity_fault(east), "");
  EXPECT_GT(area_of(west), 0);
  EXPECT_NEAR(area_of(west), area_of(east), 1e-9 * area_of(west));
}

}  // namespace
}  // namespace thiessen

#include "outlines/polygon_validity.h"

#include <gtest/gtest.h>

#include "outlines/wkt_shape.h"

namespace thiessen {
namespace {

MultiPolygon opened(const std::string& wkt) {
  MultiPolygon shape = WktShape(wkt).read();
  for (Polygon& polygon : shape) {
    polygon.outer.pop_back();
    for (Ring& hole : polygon.holes) hole.pop_back();
  }
  return shape;
}

const MultiPolygon bow_tie = opened("POLYGON ((0 0,4 4,4 0,0 4,0 0))");
const MultiPolygon square = opened("POLYGON ((0 0,4 0,4 4,0 4,0 0))");

TEST(PolygonValidity, a_valid_shape_has_no_fault) {
  EXPECT_EQ(validity_fault(square), "");
}

TEST(PolygonValidity, a_crossing_is_told_with_its_place) {
  EXPECT_EQ(validity_fault(bow_tie), "self-intersection at or near point 2 2");
}

TEST(PolygonValidity, a_ring_of_two_points_is_a_fault_and_not_a_crash) {
  EXPECT_NE(validity_fault({{{{0, 0}, {1, 1}}, {}}}), "");
  EXPECT_NE(validity_fault({{{{0, 0}, {4, 0}, {0, 4}}, {{{1, 1}}}}}), "");
  EXPECT_TRUE(made_valid({{{{0, 0}, {1, 1}}, {}}}).empty());
}

TEST(PolygonValidity, holes_count_negative_whatever_direction_rings_run_in) {
  EXPECT_EQ(plane_area(opened("POLYGON ((0 0,0 4,4 4,4 0,0 0),(1 1,2 1,2 2,1 2,1 1))")), 15);
}

// Both wings of a bow tie are of area 4.
TEST(PolygonValidity, what_is_made_valid_covers_each_piece_of_ground_once) {
  const MultiPolygon valid = made_valid(bow_tie);
  EXPECT_EQ(validity_fault(valid), "");
  EXPECT_EQ(plane_area(valid), 8);
  const MultiPolygon twice =
      opened("MULTIPOLYGON (((0 0,4 0,4 4,0 4,0 0)),((2 0,6 0,6 4,2 4,2 0)))");
  EXPECT_EQ(plane_area(made_valid(twice)), 24);
}

TEST(PolygonValidity, a_dispute_is_as_large_as_what_rules_differ_by) {
  EXPECT_EQ(disputed_area(square, square), 0);
  const MultiPolygon twice =
      opened("MULTIPOLYGON (((0 0,4 0,4 4,0 4,0 0)),((2 0,6 0,6 4,2 4,2 0)))");
  EXPECT_EQ(disputed_area(twice, made_valid(twice)), 8);
}

}  // namespace
}  // namespace thiessen

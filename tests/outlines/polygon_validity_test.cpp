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
}

TEST(PolygonValidity, holes_count_negative_whatever_direction_rings_run_in) {
  EXPECT_EQ(plane_area(opened("POLYGON ((0 0,0 4,4 4,4 0,0 0),(1 1,2 1,2 2,1 2,1 1))")), 15);
}

}  // namespace
}  // namespace thiessen

// What shapes cover, and where rules for that differ.
#include "outlines/disputed_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"
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

struct Case {
  const char* name;
  const char* wkt;
  double area;      ///< by hand
  double disputed;  ///< by hand
};

std::string name_of(const testing::TestParamInfo<Case>& parameter) {
  return parameter.param.name;
}

class GroundOf : public testing::TestWithParam<Case> {};

TEST_P(GroundOf, is_what_a_hand_finds) {
  const Ground ground = ground_of(opened(GetParam().wkt));
  EXPECT_DOUBLE_EQ(ground.area, GetParam().area);
  EXPECT_DOUBLE_EQ(plane_area(ground.shape), GetParam().area);
  EXPECT_DOUBLE_EQ(ground.disputed_area, GetParam().disputed);
  EXPECT_EQ(ground.place.has_value(), GetParam().disputed > 0);
  EXPECT_EQ(validity_fault(ground.shape), "");
}

INSTANTIATE_TEST_SUITE_P(
    DisputedGround, GroundOf,
    testing::Values(
        Case{"a_square", "POLYGON ((0 0,4 0,4 4,0 4,0 0))", 16, 0},
        Case{"an_island_in_a_lake",
             "MULTIPOLYGON(((0 0,10 0,10 10,0 10,0 5,-2 6,-2 4,0 5,0 0),(2 2,2 8,8 8,8 2,2 2)),((4 "
             "4,6 4,6 6,4 6,4 4)))",
             70, 0},
        Case{"an_island_in_a_lake_on_an_island",
             "MULTIPOLYGON(((0 0,9 0,9 9,0 9,0 0),(1 1,8 1,8 8,1 8,1 1)),((2 2,7 2,7 7,2 7,2 2),(3 "
             "3,6 3,6 6,3 6,3 3)),((4 4,5 4,5 5,4 5,4 4)))",
             32 + 16 + 1, 0},
        Case{"an_enclave_that_fills_its_hole",
             "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0),(1 1,3 1,3 3,1 3,1 1)),((1 1,3 1,3 3,1 3,1 1)))",
             16, 0},
        Case{"parts_that_share_an_edge",
             "MULTIPOLYGON(((0 0,2 0,2 2,0 2,0 0)),((2 0,4 0,4 3,2 3,2 0)))", 10, 0},
        Case{"parts_that_touch_in_a_point",
             "MULTIPOLYGON(((0 0,2 0,2 2,0 2,0 0)),((2 2,4 2,4 4,2 4,2 2)))", 8, 0},
        Case{"an_island_that_touches_the_shore",
             "MULTIPOLYGON(((0 0,6 0,6 6,0 6,0 0),(1 1,5 1,5 5,1 5,1 1)),((1 2,3 3,1 4,1 2)))",
             36 - 16 + 2, 0},
        Case{"a_bow_tie", "POLYGON ((0 0,4 4,4 0,0 4,0 0))", 8, 4},
        Case{"overlapping_parts", "MULTIPOLYGON (((0 0,2 0,2 2,0 2,0 0)),((1 1,3 1,3 3,1 3,1 1)))",
             7, 1},
        Case{"a_part_in_a_part", "MULTIPOLYGON (((0 0,9 0,9 9,0 9,0 0)),((1 1,2 1,2 2,1 2,1 1)))",
             81, 1},
        Case{"a_hole_outside", "POLYGON ((0 0,2 0,2 2,0 2,0 0),(5 5,6 5,6 6,5 6,5 5))", 4, 1},
        Case{"a_ring_wound_three_times",
             "POLYGON ((0 0,4 0,4 4,0 4,0 0,4 0,4 4,0 4,0 0,4 0,4 4,0 4,0 0))", 16, 16},
        Case{"holes_that_overlap",
             "POLYGON ((0 0,9 0,9 9,0 9,0 0),(1 1,3 1,3 3,1 3,1 1),(2 2,4 2,4 4,2 4,2 2))", 81 - 7,
             1},
        Case{"a_hole_that_is_its_shell", "POLYGON ((0 0,2 0,2 2,0 2,0 0),(0 0,2 0,2 2,0 2,0 0))", 0,
             0}),
    name_of);

TEST(DisputedGround, has_its_place_where_rings_cross) {
  EXPECT_EQ(ground_of(opened("POLYGON ((0 0,4 4,4 0,0 4,0 0))")).place, (Point{2, 2}));
  // The crossing is a vertex of the ring.
  EXPECT_EQ(ground_of(opened("POLYGON ((0 0,10 0,5 5,0 10,10 10,5 5,0 0))")).place, (Point{5, 5}));
}

TEST(DisputedGround, does_not_depend_on_where_rings_begin_and_which_way_they_run) {
  const char* const ways[] = {"MULTIPOLYGON (((0 0,4 0,4 4,0 4,0 0)),((2 0,6 0,6 4,2 4,2 0)))",
                              "MULTIPOLYGON (((2 0,6 0,6 4,2 4,2 0)),((0 0,0 4,4 4,4 0,0 0)))",
                              "MULTIPOLYGON (((4 4,0 4,0 0,4 0,4 4)),((2 0,2 4,6 4,6 0,2 0)))"};
  for (const char* const wkt : ways) {
    const Ground ground = ground_of(opened(wkt));
    EXPECT_EQ(ground.area, 24);
    EXPECT_EQ(ground.disputed_area, 8);
    EXPECT_EQ(ground.place, ground_of(opened(ways[0])).place);
  }
}

// Found by random studies: GEOS rounds a crossing of this outline's needles so that it lies beside
// a line that ends there, and then finds no face behind it.
TEST(DisputedGround, of_needles_whose_crossings_are_rounded_is_found) {
  const MultiPolygon shape = opened(
      "POLYGON (("
      "125.68267580843542 -4.7641087160208935,125.62919720306182 -4.763827563957629,"
      "125.6359892945913 -4.761241960481467,125.64149169110948 -4.75914731621719,"
      "125.64699408762766 -4.757052671952914,125.64149169110944 -4.759147316217065,"
      "125.63598929459125 -4.7612419604813425,125.64278138612076 -4.7586563570053055,"
      "125.63598929372483 -4.76124195820535,125.62919720219536 -4.763827561681512,"
      "125.69315635605493 -4.675542569111787,125.60078041908572 -4.721060744406673,"
      "125.56859721043845 -4.622241058537274,125.5396615696769 -4.672666115423129,"
      "125.52239722944721 -4.722431245230646,125.43721601654491 -4.697967828695344,"
      "125.38989722464844 -4.752796451990963,125.441593109672 -4.805409292281586,"
      "125.40725142781028 -4.8447815965281,125.40061090814923 -4.847152850461353,"
      "125.4072514278105 -4.8447815965287,125.44340180811763 -4.890066784838923,"
      "125.51760594588448 -4.855360306454146,125.52987357807474 -4.9015668838866535,"
      "125.52654892467066 -4.915015164905682,125.5232242712666 -4.92846344592471,"
      "125.52654892467068 -4.915015164905685,125.52987357807476 -4.901566883886656,"
      "125.56897230035294 -4.856007828203888,125.60497750864937 -4.921589567785859,"
      "125.6367983672847 -4.911757390466426,125.64606796189335 -4.827831036274915,"
      "125.6516543958269 -4.818344195991174,125.68267580843542 -4.7641087160208935"
      "))");
  const Ground ground = ground_of(shape);
  // The needles are narrower than 1e-11 degrees.
  EXPECT_NEAR(ground.area, std::abs(signed_area(shape[0].outer)), 1e-11);
  EXPECT_LT(ground.disputed_area, 1e-11);
  EXPECT_EQ(validity_fault(ground.shape), "");
}

}  // namespace
}  // namespace thiessen

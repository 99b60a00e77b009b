#include "outlines/basin_mending.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "outlines/longitudes.h"
#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"
#include "outlines/wkt_shape.h"

namespace thiessen {
namespace {

struct Outcome {
  std::optional<MultiPolygon> shape;
  std::vector<std::string> warnings;
  std::vector<std::string> complaints;

  double area() const {
    double sum = 0;
    for (const Polygon& polygon : shape.value()) {
      sum += signed_area(polygon.outer);
      for (const Ring& hole : polygon.holes) sum += signed_area(hole);
    }
    return sum;
  }
};

Outcome mend_wkt(const std::string& wkt, bool by_union = false) {
  const RawBasin basin{"A", "basin 'A'", 0, WktShape(wkt).read()};
  Warnings warnings;
  Complaints complaints;
  Outcome outcome{mend(basin, {by_union, false, {}}, "b.gpkg", warnings, complaints),
                  sentences_of(warnings),
                  {}};
  if (!complaints.empty()) outcome.complaints = complaints_of([&] { complaints.throw_if_any(); });
  return outcome;
}

TEST(BasinMending, a_valid_polygon_keeps_its_vertices_bit_for_bit) {
  const Outcome outcome = mend_wkt("POLYGON ((0.1 0.2,3 0.3,2.7 3.1,0.1 0.2))");
  ASSERT_TRUE(outcome.shape);
  EXPECT_EQ(outcome.shape->at(0).outer, (Ring{{0.1, 0.2}, {3, 0.3}, {2.7, 3.1}}));
  EXPECT_TRUE(outcome.warnings.empty());
}

TEST(BasinMending, rings_run_counter_clockwise_outside_and_clockwise_inside) {
  const Outcome outcome = mend_wkt("POLYGON ((0 0,0 9,9 9,9 0,0 0),(1 1,2 1,2 2,1 2,1 1))");
  ASSERT_TRUE(outcome.shape);
  EXPECT_EQ(signed_area(outcome.shape->at(0).outer), 81);
  EXPECT_EQ(signed_area(outcome.shape->at(0).holes.at(0)), -1);
  EXPECT_TRUE(outcome.warnings.empty());
}

struct Case {
  const char* name;
  const char* wkt;
  double area;       ///< by hand
  const char* says;  ///< in the warning, or in the complaint
};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

class Mended : public testing::TestWithParam<Case> {};

TEST_P(Mended, keeps_its_area_and_warns) {
  const Outcome outcome = mend_wkt(GetParam().wkt);
  ASSERT_TRUE(outcome.shape) << outcome.complaints.at(0);
  EXPECT_DOUBLE_EQ(outcome.area(), GetParam().area);
  ASSERT_EQ(outcome.warnings.size(), 1U);
  EXPECT_TRUE(contains(outcome.warnings[0], GetParam().says)) << outcome.warnings[0];
  EXPECT_EQ(validity_fault(*outcome.shape), "");
}

INSTANTIATE_TEST_SUITE_P(
    BasinMending, Mended,
    testing::Values(
        Case{"repeated_points", "POLYGON ((0 0,4 0,4 0,4 3,4 3,4 3,0 0))", 6, "3 repeated points"},
        Case{"repeated_first_point", "POLYGON ((0 0,0 0,4 0,4 3,0 0,0 0))", 6, "2 repeated points"},
        Case{"spike", "POLYGON ((0 0,4 0,9 0,4 0,4 3,0 0))", 6, "1 spike"},
        Case{"spike_over_the_seam", "POLYGON ((7 7,4 3,0 0,4 0,4 3,7 7))", 6, "1 spike"},
        Case{"long_spike", "POLYGON ((0 0,4 0,9 0,10 1,9 0,4 0,4 3,0 0))", 6, "2 spikes"},
        Case{"uneven_spike", "POLYGON ((0 0,4 0,4 5,4 3,0 3,0 0))", 12, "meets itself"},
        Case{"a_shell_without_area_and_its_hole",
             "MULTIPOLYGON (((0 0,10 0,10 10,0 10,0 0)),((20 20,20 20,20 20,20 20),(21 21,22 21,22 "
             "22,21 21)))",
             100, "1 part without area"},
        Case{"open_ring", "POLYGON ((0 0,4 0,4 3))", 6, "1 open ring"},
        Case{"parts_sharing_an_edge",
             "MULTIPOLYGON (((0 0,2 0,2 2,0 2,0 0)),((2 0,4 0,4 2,2 2,2 0)))", 8, "meets itself"},
        Case{"ring_touching_itself", "POLYGON ((0 0,4 0,4 4,2 4,3 2,1 2,2 4,0 4,0 0))", 14,
             "meets itself"},
        Case{"two_lobes_meeting_in_a_point", "POLYGON ((0 0,2 0,2 2,4 2,4 4,2 4,2 2,0 2,0 0))", 8,
             "meets itself"},
        Case{"hole_along_the_shell", "POLYGON ((0 0,4 0,4 4,0 4,0 0),(0 1,1 1,1 2,0 2,0 1))", 15,
             "meets itself"},
        Case{"hole_without_points", "POLYGON ((0 0,4 0,4 4,0 4,0 0),(1 1,2 2,1 1))", 16,
             "1 hole without area"},
        Case{"hole_on_a_line", "POLYGON ((0 0,4 0,4 4,0 4,0 0),(1 1,2 2,3 3,1 1))", 16,
             "meets itself"},
        Case{"part_without_area", "MULTIPOLYGON (((0 0,4 0,4 3,0 0)),((7 7,8 8,7 7)))", 6,
             "1 part without area"},
        // Two edges cross at (200, 400.5), above and below which they leave half a unit each: 1
        // part in 160,001 is in dispute.
        Case{"tiny_crossing",
             "POLYGON ((0 0,400 0,400 400,201 400,199 401,201 401,199 400,0 400,0 0))", 160001,
             "where it crosses itself: each piece of ground counts once, 0.000312498 % of its area "
             "(0.5) is in dispute at 200 400.5"},
        Case{"an_island_in_a_lake_of_a_shore_that_touches_itself",
             "MULTIPOLYGON(((0 0,10 0,10 10,0 10,0 5,-2 6,-2 4,0 5,0 0),(2 2,2 8,8 8,8 2,2 2)),((4 "
             "4,6 4,6 6,4 6,4 4)))",
             70, "meets itself"},
        Case{"a_part_that_fills_a_hole",
             "MULTIPOLYGON(((0 0,4 0,4 4,0 4,0 0),(1 1,3 1,3 3,1 3,1 1)),((1 1,3 1,3 3,1 3,1 1)))",
             16, "meets itself"}),
    name_of);

class Refused : public testing::TestWithParam<Case> {};

TEST_P(Refused, with_its_place) {
  const Outcome outcome = mend_wkt(GetParam().wkt);
  EXPECT_FALSE(outcome.shape);
  ASSERT_EQ(outcome.complaints.size(), 1U);
  EXPECT_TRUE(outcome.complaints[0].starts_with("b.gpkg: basin 'A' ")) << outcome.complaints[0];
  EXPECT_TRUE(contains(outcome.complaints[0], GetParam().says)) << outcome.complaints[0];
}

INSTANTIATE_TEST_SUITE_P(
    BasinMending, Refused,
    testing::Values(
        Case{"bow_tie", "POLYGON ((0 0,4 4,4 0,0 4,0 0))", 0, "2 2"},
        Case{"uneven_bow_tie", "POLYGON ((0 0,4 4,4 0,0 2,0 0))", 0, "in dispute at"},
        Case{"ring_overlapping_itself", "POLYGON ((0 0,4 0,4 4,2 4,1 2,3 2,2 4,0 4,0 0))", 0,
             "in dispute"},
        Case{"overlapping_parts", "MULTIPOLYGON (((0 0,2 0,2 2,0 2,0 0)),((1 1,3 1,3 3,1 3,1 1)))",
             0, "at"},
        Case{"one_part_twice", "MULTIPOLYGON (((0 0,2 0,2 2,0 2,0 0)),((0 0,2 0,2 2,0 2,0 0)))", 0,
             "at"},
        Case{"nested_parts", "MULTIPOLYGON (((0 0,9 0,9 9,0 9,0 0)),((1 1,2 1,2 2,1 2,1 1)))", 0,
             "at"},
        Case{"hole_outside", "POLYGON ((0 0,2 0,2 2,0 2,0 0),(5 5,6 5,6 6,5 6,5 5))", 0, "5 5"},
        Case{"hole_that_sticks_out", "POLYGON ((0 0,4 0,4 4,0 4,0 0),(3 1,5 1,5 2,3 2,3 1))", 0,
             "at 4 1"},
        Case{"hole_equal_to_its_shell", "POLYGON ((0 0,2 0,2 2,0 2,0 0),(0 0,2 0,2 2,0 2,0 0))", 0,
             "has no area"},
        Case{"ring_wound_twice", "POLYGON ((0 0,4 0,4 4,0 4,0 0,4 0,4 4,0 4,0 0))", 0, "at"},
        // The same crossing where it is 1 part in 80,002.
        Case{"crossing_not_tiny_enough",
             "POLYGON ((0 0,200 0,200 200,101 200,99 201,101 201,99 200,0 200,0 0))", 0,
             "crosses or overlaps itself: 0.001249969 % of its area (0.5) is in dispute at 100 "
             "200.5"},
        Case{"too_few_points", "POLYGON ((0 0,1 1,0 0))", 0, "no area"},
        Case{"no_area", "POLYGON ((0 0,1 1,2 2,0 0))", 0, "no area"},
        // Two parts overlap by one unit and a hole of one unit lies outside both: in all, the area
        // is the same by both rules.
        Case{"faults_that_make_up_for_each_other",
             "MULTIPOLYGON (((0 0,4 0,4 4,0 4,0 0),(8 8,9 8,9 9,8 9,8 8)),((3 3,7 3,7 7,3 7,3 3)))",
             0, "at"}),
    name_of);

TEST(BasinMending, by_union_counts_each_piece_of_ground_once_and_says_what_is_in_dispute) {
  const Outcome bow = mend_wkt("POLYGON ((0 0,10 10,10 0,0 10,0 0))", true);
  EXPECT_DOUBLE_EQ(bow.area(), 50);
  ASSERT_EQ(bow.warnings.size(), 1U);
  EXPECT_TRUE(contains(bow.warnings[0], "50 % of its area (25) is in dispute at 5 5"))
      << bow.warnings[0];
  const Outcome parts =
      mend_wkt("MULTIPOLYGON (((0 0,5.25 0,5.25 10,0 10,0 0)),((5 0,10 0,10 10,5 10,5 0)))", true);
  EXPECT_DOUBLE_EQ(parts.area(), 100);
  EXPECT_TRUE(contains(parts.warnings.at(0), "2.5 % of its area (2.5) is in dispute"));
  EXPECT_TRUE(mend_wkt("POLYGON ((0 0,4 0,4 4,0 0))", true).warnings.empty());
}

TEST(BasinMending, every_refusal_has_a_hint) {
  for (const char* const wkt : {"POLYGON ((0 0,4 4,4 0,0 4,0 0))", "POLYGON ((0 0,1 1,2 2,0 0))"}) {
    Warnings warnings;
    Complaints complaints;
    mend({"A", "basin 'A'", 0, WktShape(wkt).read()}, {}, "b", warnings, complaints);
    try {
      complaints.throw_if_any();
      ADD_FAILURE() << wkt;
    } catch (const Error& error) {
      EXPECT_FALSE(error.messages().at(0).hint.empty()) << wkt;
    }
  }
}

TEST(Longitudes, run_on_over_the_antimeridian) {
  MultiPolygon shape = {
      {{{170, 0}, {-170, 0}, {-170, 10}, {170, 10}}, {{{-175, 2}, {-172, 2}, {-172, 4}}}}};
  WideEdges wide;
  ASSERT_EQ(unwrap_longitudes(shape, wide), "");
  EXPECT_EQ(shape[0].outer, (Ring{{170, 0}, {190, 0}, {190, 10}, {170, 10}}));
  EXPECT_EQ(shape[0].holes[0], (Ring{{185, 2}, {188, 2}, {188, 4}}));
}

TEST(Longitudes, begin_in_the_first_turn) {
  MultiPolygon shape = {{{{355, 0}, {365, 0}, {365, 10}}, {}},
                        {{{-179, 0}, {175, 0}, {175, 5}}, {}}};
  WideEdges wide;
  ASSERT_EQ(unwrap_longitudes(shape, wide), "");
  EXPECT_EQ(shape[0].outer, (Ring{{-5, 0}, {5, 0}, {5, 10}}));
  EXPECT_EQ(shape[1].outer, (Ring{{181, 0}, {175, 0}, {175, 5}}));
}

TEST(Longitudes, go_all_round_along_a_pole) {
  const Ring earth = {{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};
  const Ring cap = {{-180, 60}, {0, 60}, {180, 60}, {180, 90}, {-180, 90}};
  MultiPolygon shape = {
      {earth, {}}, {cap, {}}, {{{170, 60}, {-170, 60}, {-170, 90}, {170, 90}}, {}}};
  WideEdges wide;
  ASSERT_EQ(unwrap_longitudes(shape, wide), "");
  EXPECT_EQ(shape[0].outer, earth);
  EXPECT_EQ(shape[1].outer, cap);
  EXPECT_EQ(shape[2].outer, (Ring{{170, 60}, {190, 60}, {190, 90}, {170, 90}}));
}

}  // namespace
}  // namespace thiessen

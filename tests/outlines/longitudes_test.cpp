#include "outlines/longitudes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/complaints.h"
#include "outlines/ellipsoid_strip.h"

namespace thiessen {
namespace {

MultiPolygon unwrapped(MultiPolygon shape) {
  WideEdges found;
  EXPECT_EQ(unwrap_longitudes(shape, found), "");
  return shape;
}

Ring closed(Ring ring) {
  ring.push_back(ring.front());
  return ring;
}

TEST(UnwrapLongitudes, leaves_alone_what_lies_on_one_side) {
  const Ring ring = closed({{10.1, -0.3}, {20, 0}, {15, 5}});
  EXPECT_EQ(unwrapped({{ring, {}}})[0].outer, ring);
}

TEST(UnwrapLongitudes, an_edge_over_half_a_turn_goes_the_short_way_and_holes_go_with_it) {
  const Ring outer = closed({{170, 0}, {-170, 0}, {-170, 10}, {170, 10}});
  const Ring hole = closed({{-178, 2}, {-176, 4}, {-176, 2}});
  const MultiPolygon shape = unwrapped({{outer, {hole}}});
  EXPECT_EQ(shape[0].outer, closed({{170, 0}, {190, 0}, {190, 10}, {170, 10}}));
  EXPECT_EQ(shape[0].holes.at(0), closed({{182, 2}, {184, 4}, {184, 2}}));
}

TEST(UnwrapLongitudes, law_1_the_least_longitude_of_each_part_lies_within_minus_180_and_180) {
  for (double west = -560; west < 560; west += 35) {
    const MultiPolygon shape =
        unwrapped({{closed({{west, 0}, {west + 20, 0}, {west + 20, 9}, {west, 9}}), {}}});
    double least = shape[0].outer[0].x;
    double largest = least;
    for (const Point point : shape[0].outer) {
      least = std::min(least, point.x);
      largest = std::max(largest, point.x);
      EXPECT_EQ(std::remainder(point.x - west, 10), 0);
    }
    EXPECT_GE(least, -180) << west;
    EXPECT_LT(least, 180) << west;
    EXPECT_EQ(largest - least, 20) << west;
  }
}

TEST(UnwrapLongitudes, a_ring_round_the_earth_holds_its_pole_and_is_cut_at_the_antimeridian) {
  Ring ring;
  for (int longitude = -170; longitude < 190; longitude += 20)
    ring.push_back({1.0 * longitude, 60});
  CurvedShape cap{unwrapped({{closed(ring), {}}}), {}};
  for (Polygon& part : cap.shape) {
    ASSERT_EQ(part.outer.front(), part.outer.back()) << "closed rings stay closed";
    part.outer.pop_back();
  }
  EXPECT_NEAR(area_on_earth(cap) / strip_area(60, 90, 360), 1, 1e-11);
}

TEST(UnwrapLongitudes, an_open_ring_stays_open_so_that_it_is_noticed) {
  const MultiPolygon shape = unwrapped({{{{170, 0}, {-170, 0}, {-170, 10}}, {}}});
  EXPECT_EQ(shape[0].outer, (Ring{{170, 0}, {190, 0}, {190, 10}}));
}

TEST(UnwrapLongitudes, tells_of_a_ring_of_which_no_pole_is_nearer) {
  MultiPolygon shape = {{closed({{0, 0}, {80, 0}, {160, 0}, {-120, 0}, {-40, 0}}), {}}};
  WideEdges found;
  EXPECT_TRUE(contains(unwrap_longitudes(shape, found), "neither pole is nearer"));
}

}  // namespace
}  // namespace thiessen

// The rectangle that holds the gauges.
#include "rainfall/network/extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/ring_location.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

Box box_of_extent(const std::vector<Point>& places, Metric metric, double margin) {
  return box_of(extent_of(places, metric, margin).value().shape.at(0).outer);
}

TEST(Extent, law_1_in_a_plane_is_the_box_grown_by_a_share_of_its_larger_side) {
  const Box box = box_of_extent({{1, 2}, {5, 3}, {2, 4}}, Metric::planar, 25);
  EXPECT_EQ(box.low, (Point{0, 1}));
  EXPECT_EQ(box.high, (Point{6, 5}));
}

TEST(Extent, law_2_in_a_plane_is_nothing_without_width_and_height) {
  EXPECT_FALSE(extent_of({}, Metric::planar, 10));
  EXPECT_FALSE(extent_of(std::vector<Point>{{1, 2}}, Metric::planar, 10));
  EXPECT_FALSE(extent_of(std::vector<Point>{{1, 2}, {1, 5}}, Metric::planar, 0));
  EXPECT_TRUE(extent_of(std::vector<Point>{{1, 2}, {1, 5}}, Metric::planar, 1));
}

TEST(Extent, law_3_on_the_earth_holds_every_place_at_one_turn_or_another) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const Point middle{seeded.uniform(-180, 180), seeded.uniform(-80, 80)};
    std::vector<Point> places;
    for (int i = 0; i < 5; ++i) {
      const double x = middle.x + seeded.uniform(-20, 20);
      places.push_back({std::remainder(x, 360), middle.y + seeded.uniform(-9, 9)});
    }
    const Ring ring = extent_of(places, Metric::geodesic, 5).value().shape.at(0).outer;
    EXPECT_LT(box_of(ring).width(), 40 * 1.1 + 1e-9);  // the shorter way round
    for (const Point p : places) {
      const bool is_held =
          locate(ring, p) != Where::outside || locate(ring, {p.x + 360, p.y}) != Where::outside;
      EXPECT_TRUE(is_held) << p.x << ' ' << p.y;
    }
  }
}

TEST(Extent, law_4_on_the_earth_stays_between_the_poles_and_within_a_turn) {
  const Box polar = box_of_extent({{0, 80}, {10, 89}}, Metric::geodesic, 50);
  EXPECT_EQ(polar.high.y, 90);
  const Box wide = box_of_extent({{-170, 0}, {-60, 5}, {60, 0}, {170, 5}}, Metric::geodesic, 50);
  EXPECT_EQ(wide.low.x, -180);
  EXPECT_EQ(wide.high.x, 180);
}

// Four gauges round the south pole: a cap, and not a wedge.
TEST(Extent, law_7_without_a_gap_of_180_degrees_is_the_cap_down_to_the_farthest) {
  const Box south =
      box_of_extent({{0, -75}, {90, -80}, {180, -75}, {-90, -85}}, Metric::geodesic, 10);
  EXPECT_EQ(south.low, (Point{-180, -90}));
  EXPECT_EQ(south.high.x, 180);
  EXPECT_DOUBLE_EQ(south.high.y, -90 + 15 * 1.1);
  const Box north = box_of_extent({{0, 10}, {120, 20}, {-120, 89}}, Metric::geodesic, 50);
  EXPECT_DOUBLE_EQ(north.low.y, 90 - 80 * 1.5);
  EXPECT_EQ(north.high, (Point{180, 90}));
}

TEST(Extent, law_8_in_both_hemispheres_it_is_all_longitudes) {
  const Box box = box_of_extent({{0, 10}, {120, -20}, {-120, 5}}, Metric::geodesic, 10);
  EXPECT_EQ(box.low, (Point{-180, -56}));
  EXPECT_EQ(box.high, (Point{180, 46}));
}

TEST(Extent, law_9_a_gauge_at_a_pole_has_no_longitude) {
  const Box box = box_of_extent({{0, 80}, {10, 82}, {-170, 90}}, Metric::geodesic, 0);
  EXPECT_EQ(box.low, (Point{0, 80}));
  EXPECT_EQ(box.high, (Point{10, 90}));
}

TEST(Extent, law_5_of_one_place_is_the_whole_earth) {
  const Box box = box_of_extent({{10, 50}}, Metric::geodesic, 5);
  EXPECT_EQ(box.low, (Point{-180, -90}));
  EXPECT_EQ(box.high, (Point{180, 90}));
}

TEST(Extent, law_6_no_edge_on_the_earth_is_longer_than_a_quarter_of_a_turn) {
  for (const auto& places : std::vector<std::vector<Point>>{
           {{10, 50}}, {{-100, 0}, {30, 10}}, {{-170, 0}, {-60, 5}, {60, 0}, {170, 5}}}) {
    const Ring ring = extent_of(places, Metric::geodesic, 5).value().shape.at(0).outer;
    for (std::size_t i = 0; i < ring.size(); ++i)
      EXPECT_LE(std::abs(ring[(i + 1) % ring.size()].x - ring[i].x), 90 + 1e-9);
  }
}

}  // namespace
}  // namespace thiessen

#include "map/sheet/longitude_window.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace thiessen {
namespace {

TEST(LongitudeWindow, goes_the_shorter_way_round) {
  LongitudeCensus census;
  census.add(170);
  census.add(-175);
  const LongitudeWindow window = census.window();
  EXPECT_NEAR(window.west, 170, 1e-9);
  EXPECT_NEAR(window.span, 15, 1e-9);
  EXPECT_NEAR(window.place(-175), 185, 1e-9);
  EXPECT_NEAR(window.place(170), 170, 1e-9);
}

TEST(LongitudeWindow, edges_count_and_not_vertices_alone) {
  LongitudeCensus census;
  census.add(Ring{{-100, 0}, {40, 0}, {40, 10}, {-100, 10}});
  const LongitudeWindow window = census.window();
  EXPECT_NEAR(window.west, -100, 1e-9);
  EXPECT_NEAR(window.span, 140, 1e-9);
}

TEST(LongitudeWindow, an_edge_over_the_antimeridian_goes_the_short_way) {
  LongitudeCensus census;
  census.add(Ring{{170, 0}, {-160, 0}, {-160, 10}, {170, 10}});
  EXPECT_NEAR(census.window().west, 170, 1e-9);
  EXPECT_NEAR(census.window().span, 30, 1e-9);
}

TEST(LongitudeWindow, the_whole_earth_has_no_gap) {
  LongitudeCensus census;
  census.add(Ring{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}});
  EXPECT_EQ(census.window().west, -180);
  EXPECT_EQ(census.window().span, 360);
  LongitudeCensus around;
  Ring ring;
  for (int lon = -180; lon < 180; lon += 15) ring.push_back({1.0 * lon, 70});
  around.add(ring);
  EXPECT_EQ(around.window().span, 360);
}

TEST(LongitudeWindow, one_place_has_no_width) {
  LongitudeCensus census;
  census.add(12.5);
  EXPECT_NEAR(census.window().west, 12.5, 1e-9);
  EXPECT_NEAR(census.window().span, 0, 1e-9);
}

TEST(UnwrappedRing, round_the_earth_is_closed_over_its_pole) {
  Ring ring;
  for (int lon = -180; lon < 180; lon += 30) ring.push_back({1.0 * lon, -70});
  const Ring closed = unwrapped(ring, {});
  ASSERT_EQ(closed.size(), ring.size() + 3);
  EXPECT_EQ(closed[12], (Point{180, -70}));
  EXPECT_EQ(closed[13], (Point{180, -90}));
  EXPECT_EQ(closed[14], (Point{-180, -90}));
}

// Brute force: the widest gap between neighbouring longitudes, over the antimeridian too.
TEST(LongitudeWindow, law_1_leaves_out_the_widest_gap_and_holds_every_longitude) {
  const unsigned seed = std::random_device()();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> anywhere(-180, 540);
  for (int round = 0; round < 500; ++round) {
    std::vector<double> turned;
    LongitudeCensus census;
    for (auto n = random() % 30 + 1; n > 0; --n) {
      const double longitude = anywhere(random);
      census.add(longitude);
      turned.push_back(std::fmod(longitude + 180, 360.0));
    }
    std::sort(turned.begin(), turned.end());
    double widest = turned.front() + 360 - turned.back();
    for (std::size_t i = 1; i < turned.size(); ++i)
      widest = std::max(widest, turned[i] - turned[i - 1]);
    const LongitudeWindow window = census.window();
    ASSERT_NEAR(window.span, 360 - widest, 1e-9);
    for (const double longitude : turned) {
      const double placed = window.place(longitude - 180);
      ASSERT_NEAR(std::remainder(placed - (longitude - 180), 360), 0, 1e-9);
      ASSERT_GE(placed, window.west - 1e-9);
      // The westernmost itself may round to a whole turn further on.
      if (placed < window.west + 360 - 1e-9) {
        ASSERT_LE(placed, window.east() + 1e-9);
      }
    }
  }
}

TEST(LongitudeWindow, of_nothing_is_the_whole_turn) {
  EXPECT_EQ(LongitudeCensus().window().west, -180);
  EXPECT_EQ(LongitudeCensus().window().span, 360);
}

TEST(UnwrappedRing, runs_on_from_its_first_point_which_lies_in_the_window) {
  const Ring over = {{175, 0}, {-175, 0}, {-175, 5}, {175, 5}};
  EXPECT_EQ(unwrapped(over, {170, 20}), (Ring{{175, 0}, {185, 0}, {185, 5}, {175, 5}}));
  EXPECT_EQ(unwrapped(over, {-190, 20}), (Ring{{-185, 0}, {-175, 0}, {-175, 5}, {-185, 5}}));
  EXPECT_EQ(unwrapped({}, {}), Ring{});
}

TEST(UnwrappedRing, along_a_pole_goes_as_its_coordinates_say) {
  const Ring earth = {{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};
  EXPECT_EQ(unwrapped(earth, {}), earth);
}

}  // namespace
}  // namespace thiessen

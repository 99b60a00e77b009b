#include "earth/nearest/nearest_in_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

std::vector<PlaceIndex> all_of(std::size_t count) {
  std::vector<PlaceIndex> all;
  for (std::uint32_t i = 0; i < count; ++i) all.push_back(PlaceIndex{i});
  return all;
}

// In whole numbers, where squares are exact and ties are many.
TEST(NearestInPlane, law_1_of_equally_near_rivals_it_is_the_first_by_number_in_whatever_order) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(500); ++round) {
    const auto point = [&](std::int64_t side) {
      return Point{static_cast<double>(seeded.whole(-side, side)),
                   static_cast<double>(seeded.whole(-side, side))};
    };
    std::vector<Point> places;
    for (int i = 0; i < 20; ++i) places.push_back(point(4));
    const Point p = point(6);
    std::size_t expected = 0;
    const auto square = [&](std::size_t i) {
      return (places[i].x - p.x) * (places[i].x - p.x) + (places[i].y - p.y) * (places[i].y - p.y);
    };
    for (std::size_t i = 1; i < places.size(); ++i) {
      if (square(i) < square(expected)) expected = i;
    }
    std::vector<PlaceIndex> rivals = all_of(places.size());
    std::shuffle(rivals.begin(), rivals.end(), seeded.generator());
    const auto found = NearestInPlane(places).nearest(p, rivals);
    ASSERT_TRUE(found);
    ASSERT_EQ(index(*found), expected);
  }
}

// From 1e9 away the squares of both distances round to the same.
TEST(NearestInPlane, law_2_one_last_bit_decides) {
  const std::vector<Point> places{{1e6 + 2, 0}, {1e6, 0}};
  const NearestInPlane nearest(places);
  const double middle = 1e6 + 1;
  EXPECT_EQ(nearest.nearest({middle, 1e9}, all_of(2)), PlaceIndex{0});
  EXPECT_EQ(nearest.nearest({std::nextafter(middle, 0), 1e9}, all_of(2)), PlaceIndex{1});
  EXPECT_EQ(nearest.nearest({std::nextafter(middle, 1e9), -1e9}, all_of(2)), PlaceIndex{0});
}

TEST(NearestInPlane, law_3_only_rivals_count) {
  const NearestInPlane nearest(std::vector<Point>{{0, 0}, {5, 0}, {9, 0}});
  EXPECT_EQ(nearest.nearest({0, 1}, std::vector{PlaceIndex{2}, PlaceIndex{1}}), PlaceIndex{1});
}

TEST(NearestInPlane, law_4_what_is_too_large_or_too_small_counts_as_the_nearest_that_is_not) {
  const NearestInPlane nearest(std::vector<Point>{{-1, 0}, {1, 0}, {0, 3}});
  EXPECT_EQ(nearest.nearest({HUGE_VAL, 0}, all_of(3)), PlaceIndex{1});
  EXPECT_EQ(nearest.nearest({0, 1e300}, all_of(3)), PlaceIndex{2});
  EXPECT_EQ(nearest.nearest({1e-300, 0}, all_of(3)), PlaceIndex{0});  // as at 0, a tie
}

TEST(NearestInPlane, law_5_a_ball_s_points_are_at_height_0_and_off_by_their_rounding_at_most) {
  Seeded seeded;
  const NearestInPlane nearest(std::vector<Point>{{0, 0}});
  for (int i = 0; i < 100; ++i) {
    const Point p{seeded.uniform(-1e6, 1e6), seeded.uniform(-1e6, 1e6)};
    const Direction there = nearest.in_space(p);
    EXPECT_EQ(there.z, 0);
    EXPECT_EQ((Point{there.x, there.y}), p);
    EXPECT_GE(nearest.rounding(there), std::nextafter(std::abs(p.x), 1e9) - std::abs(p.x));
    EXPECT_LT(nearest.rounding(there), 1e-8);
  }
}

}  // namespace
}  // namespace thiessen

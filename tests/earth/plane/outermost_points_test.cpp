#include "earth/plane/outermost_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "earth/random_points.h"

namespace thiessen {
namespace {

/// So many points of a region so many degrees wide, which may lie over the antimeridian.
std::vector<Point> points_of_region(Seeded& seeded, double west, double width, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double east = west + width * seeded.uniform(0, 1);
    points.push_back({std::remainder(east, 360), seeded.uniform(-60, 70)});
  }
  return points;
}

// Found again by sorting: the region begins east of the widest gap.
TEST(OutermostPoints, law_1_the_region_leaves_out_the_widest_gap_and_holds_all_points) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const double width = seeded.uniform(1, 170);
    const auto points = points_of_region(seeded, seeded.uniform(-180, 180), width, 500);
    std::vector<double> longitudes;
    for (const Point p : points) longitudes.push_back(p.x);
    std::sort(longitudes.begin(), longitudes.end());
    double gap = longitudes.front() + 360 - longitudes.back();
    double west = longitudes.front();
    for (std::size_t i = 1; i < longitudes.size(); ++i) {
      if (longitudes[i] - longitudes[i - 1] <= gap) continue;
      gap = longitudes[i] - longitudes[i - 1];
      west = longitudes[i];
    }
    const auto found = outermost_points(points);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::remainder(found->west - west, 360), 0, 1e-12);
    EXPECT_NEAR(found->width, 360 - gap, 1e-12);
    for (const Point p : points) {
      EXPECT_GE(p.y, found->south);
      EXPECT_LE(p.y, found->north);
    }
  }
}

TEST(OutermostPoints, law_2_those_that_are_kept_are_points_of_the_study_and_few) {
  Seeded seeded;
  const auto points = points_of_region(seeded, 150, 60, 20000);
  const auto found = outermost_points(points);
  ASSERT_TRUE(found);
  EXPECT_LE(found->points.size(), 2048u);
  EXPECT_TRUE(std::is_sorted(found->points.begin(), found->points.end()));
  for (const Point p : found->points) {
    EXPECT_GE(p.x, found->west);
    EXPECT_LE(p.x, found->west + found->width);
    const bool is_of_study = std::any_of(points.begin(), points.end(), [&](Point q) {
      return q.y == p.y && std::abs(std::remainder(q.x - p.x, 360)) < 1e-12;
    });
    EXPECT_TRUE(is_of_study);
  }
}

// Whatever is beyond all others, in longitude, in latitude or nearly so within a strip.
TEST(OutermostPoints, law_3_what_is_farthest_in_its_strip_is_kept) {
  Seeded seeded;
  const auto points = points_of_region(seeded, -20, 40, 5000);
  const auto found = outermost_points(points);
  ASSERT_TRUE(found);
  const auto is_kept = [&](Point p) {
    return std::any_of(found->points.begin(), found->points.end(), [&](Point q) {
      return q.y == p.y && std::abs(std::remainder(q.x - p.x, 360)) < 1e-12;
    });
  };
  for (const Point p : points) {
    const auto is_beyond = [&](auto&& near, auto&& beyond) {
      return std::none_of(points.begin(), points.end(),
                          [&](Point q) { return near(q) && beyond(q); });
    };
    const auto same_longitudes = [&](Point q) { return std::abs(q.x - p.x) < 40. / 512; };
    const auto same_latitudes = [&](Point q) { return std::abs(q.y - p.y) < 130. / 512; };
    if (is_beyond(same_longitudes, [&](Point q) { return q.y > p.y; }) ||
        is_beyond(same_longitudes, [&](Point q) { return q.y < p.y; }) ||
        is_beyond(same_latitudes, [&](Point q) { return q.x > p.x; }) ||
        is_beyond(same_latitudes, [&](Point q) { return q.x < p.x; })) {
      EXPECT_TRUE(is_kept(p)) << p.x << ' ' << p.y;
    }
  }
}

TEST(OutermostPoints, law_4_the_order_of_the_points_does_not_matter) {
  Seeded seeded;
  auto points = points_of_region(seeded, 170, 30, 1000);
  points.push_back({33, 90});
  const auto found = outermost_points(points);
  std::shuffle(points.begin(), points.end(), seeded.generator());
  const auto other = outermost_points(points);
  ASSERT_TRUE(found && other);
  EXPECT_EQ(found->points, other->points);
  EXPECT_EQ(found->west, other->west);
}

TEST(OutermostPoints, law_5_a_pole_has_no_longitude_and_takes_the_middle_one) {
  const auto found = outermost_points(std::vector<Point>{{10, 80}, {30, 85}, {-170, 90}});
  ASSERT_TRUE(found);
  const double turn = found->west - 10;  // longitudes may run on by whole turns
  EXPECT_EQ(std::remainder(turn, 360), 0);
  EXPECT_EQ(found->width, 20);
  EXPECT_EQ(found->points, (std::vector<Point>{{turn + 10, 80}, {turn + 20, 90}, {turn + 30, 85}}));
  const auto pole = outermost_points(std::vector<Point>{{77, -90}});
  ASSERT_TRUE(pole);
  EXPECT_EQ(pole->width, 0);
  EXPECT_EQ(pole->south, -90);
}

TEST(OutermostPoints, law_6_without_a_gap_of_a_degree_it_is_the_whole_turn_and_of_nothing_none) {
  Seeded seeded;
  const auto found = outermost_points(points_of_region(seeded, -180, 360, 20000));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->width, 360);
  EXPECT_FALSE(outermost_points({}));
}

}  // namespace
}  // namespace thiessen

#include "map/ink/dashes.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Dashes, begin_and_end_the_line_and_are_equally_long) {
  for (const double length : {8.5, 10.0, 33.0, 400.0, 12345.6}) {
    const auto result = dashes(length, 10, 7);
    ASSERT_GE(result.size(), 2u);
    EXPECT_EQ(result.front().from, 0);
    EXPECT_EQ(result.back().to, length);
    const double dash = result[0].to;
    const double gap = result[1].from - result[0].to;
    EXPECT_NEAR(gap / dash, 0.7, 1e-9);
    for (std::size_t i = 0; i < result.size(); ++i) {
      EXPECT_NEAR(result[i].to - result[i].from, dash, 1e-9);
    }
    if (length > 100) {
      EXPECT_NEAR(dash, 10, 1);
    }
  }
}

TEST(Dashes, of_three_dashes_and_two_gaps_fit_exactly) {
  const auto result = dashes(44, 10, 7);
  ASSERT_EQ(result.size(), 3u);
  EXPECT_EQ(result[1].from, 17);
  EXPECT_EQ(result[1].to, 27);
}

TEST(Dashes, of_a_line_shorter_than_a_gap_are_one) {
  EXPECT_EQ(dashes(6, 10, 7).size(), 1u);
  EXPECT_EQ(dashes(0, 10, 7).size(), 1u);
}

TEST(Dashes, follow_a_line_round_its_corners) {
  // 44 long with a corner at 20: dashes to 10, from 17 to 27, and from 34.
  const std::vector<Point> line{{0, 0}, {20, 0}, {20, 24}};
  const auto result = dashed(line, 10, 7);
  ASSERT_EQ(result.size(), 3u);
  EXPECT_EQ(result[0], (std::vector<Point>{{0, 0}, {10, 0}}));
  EXPECT_EQ(result[1], (std::vector<Point>{{17, 0}, {20, 0}, {20, 7}}));
  EXPECT_EQ(result[2], (std::vector<Point>{{20, 14}, {20, 24}}));
}

TEST(Dashes, of_a_point_or_nothing_are_none) {
  EXPECT_TRUE(dashed(std::vector<Point>{}, 10, 7).empty());
  EXPECT_TRUE(dashed(std::vector<Point>{{3, 4}}, 10, 7).empty());
  EXPECT_TRUE(dashed(std::vector<Point>{{3, 4}, {3, 4}}, 10, 7).empty());
}

}  // namespace
}  // namespace thiessen

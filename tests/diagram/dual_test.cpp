#include "diagram/dual.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace thiessen {
namespace {

constexpr PlaceIndex place(std::uint32_t i) {
  return PlaceIndex{i};
}

TEST(Dual, is_put_in_rising_order_and_triangles_keep_their_direction) {
  Dual dual{{{place(7), place(2), place(3)}, {place(1), place(0), place(9)}},
            {{place(5), place(4), 2}, {place(1), place(3), 1}}};
  put_in_order(dual);
  EXPECT_EQ(dual.triangles, (std::vector<DualTriangle>{{place(0), place(9), place(1)},
                                                       {place(2), place(3), place(7)}}));
  ASSERT_EQ(dual.borders.size(), 2U);
  EXPECT_EQ(dual.borders[0].first, place(1));
  EXPECT_EQ(dual.borders[1].first, place(4));
  EXPECT_EQ(dual.borders[1].second, place(5));
}

TEST(Dual, joins_the_borders_of_a_pair) {
  Dual dual{{}, {{place(1), place(0), 2}, {place(0), place(2), 8}, {place(0), place(1), 3}}};
  put_in_order(dual);
  ASSERT_EQ(dual.borders.size(), 2U);
  EXPECT_EQ(dual.borders[0].second, place(1));
  EXPECT_EQ(dual.borders[0].length, 5);
}

}  // namespace
}  // namespace thiessen

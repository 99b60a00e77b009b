#include "tessellation/parity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace thiessen {
namespace {

using Four = std::array<PointId, 4>;

constexpr Four sorted{PointId{2}, PointId{3}, PointId{5}, PointId{7}};

/// By counting the pairs that stand the wrong way round.
Parity by_inversions(const Four& order) {
  int inversions = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = i + 1; k < 4; ++k) inversions += order[k] < order[i] ? 1 : 0;
  }
  return inversions % 2 == 0 ? Parity::even : Parity::odd;
}

TEST(Parity, law_1_of_every_order_is_that_of_its_inversions) {
  Four order = sorted;
  int orders = 0;
  do {
    EXPECT_EQ(parity(sorted, order), by_inversions(order));
    EXPECT_EQ(parity(order, sorted), by_inversions(order));
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orders, 24);
}

TEST(Parity, law_2_of_one_order_after_another_is_the_product_of_both) {
  Four middle = sorted;
  do {
    Four order = sorted;
    do {
      const bool is_even = by_inversions(middle) == by_inversions(order);
      EXPECT_EQ(parity(middle, order), is_even ? Parity::even : Parity::odd);
    } while (std::next_permutation(order.begin(), order.end()));
  } while (std::next_permutation(middle.begin(), middle.end()));
}

TEST(Parity, law_3_there_is_none_where_the_points_are_not_the_same) {
  EXPECT_EQ(parity(sorted, {PointId{2}, PointId{3}, PointId{5}, PointId{8}}), Parity::none);
  EXPECT_EQ(parity(sorted, {PointId{2}, PointId{3}, PointId{5}, PointId{5}}), Parity::none);
}

TEST(Parity, law_4_what_comes_after_the_count_does_not_matter) {
  const Four other{PointId{3}, PointId{2}, PointId{9}, PointId{9}};
  EXPECT_EQ(parity(sorted, other, 2), Parity::odd);
  EXPECT_EQ(parity(sorted, other, 3), Parity::none);
  EXPECT_EQ(parity(sorted, other, 0), Parity::even);
}

}  // namespace
}  // namespace thiessen

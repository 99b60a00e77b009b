#include "rainfall/methods/weight_sums.h"

#include <gtest/gtest.h>

#include <vector>

namespace thiessen {
namespace {

using Weights = std::vector<PlaceWeight>;

TEST(WeightSums, law_1_are_scaled_to_add_up_to_one_in_the_order_of_the_places) {
  WeightSums sums(5);
  sums.add(PlaceIndex{4}, 3);
  sums.add(PlaceIndex{1}, 1);
  sums.add(PlaceIndex{4}, 1);
  sums.add(PlaceIndex{0}, 3);
  EXPECT_EQ(sums.take(),
            (Weights{{PlaceIndex{0}, 0.375}, {PlaceIndex{1}, 0.125}, {PlaceIndex{4}, 0.5}}));
}

TEST(WeightSums, law_2_begin_anew_with_each_basin) {
  WeightSums sums(3);
  sums.add(PlaceIndex{2}, 5);
  sums.take();
  EXPECT_TRUE(sums.take().empty());
  sums.add(PlaceIndex{1}, 2);
  EXPECT_EQ(sums.take(), (Weights{{PlaceIndex{1}, 1}}));
}

TEST(WeightSums, law_3_leave_out_what_is_no_more_than_rounding) {
  WeightSums sums(3);
  sums.add(PlaceIndex{0}, 1);
  sums.add(PlaceIndex{1}, 1e-15);
  sums.add(PlaceIndex{2}, 1e-13);
  const Weights weights = sums.take();
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_EQ(weights[1].place, PlaceIndex{2});
}

TEST(WeightSums, law_4_add_up_sums_of_several_points_with_their_normals) {
  WeightSums sums(3);
  sums.add(PlaceIndex{2}, 0.5, 4);
  sums.add(PlaceIndex{0}, 0.5, 2);
  const std::vector<PlaceSum> first = sums.take_sums();
  ASSERT_EQ(first.size(), 2u);
  EXPECT_EQ(first[0].place, PlaceIndex{0});
  EXPECT_EQ(first[1].of_normals, 2);
  EXPECT_TRUE(sums.take_sums().empty());
  sums.add(first);
  sums.add(PlaceIndex{2}, 0.5, 2);
  sums.add(PlaceIndex{1}, 0.5, 1);
  EXPECT_EQ(sums.take(),
            (Weights{{PlaceIndex{0}, 0.25, 2}, {PlaceIndex{1}, 0.25, 1}, {PlaceIndex{2}, 0.5, 3}}));
}

}  // namespace
}  // namespace thiessen

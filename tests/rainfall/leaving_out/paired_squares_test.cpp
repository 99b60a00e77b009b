#include "rainfall/leaving_out/paired_squares.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

// Abramowitz and Stegun, table 26.10.
TEST(PairedSquares, critical_t_of_the_table) {
  EXPECT_NEAR(critical_t(4), 2.776, 0.03);
  EXPECT_NEAR(critical_t(9), 2.262, 0.01);
  EXPECT_NEAR(critical_t(29), 2.045, 0.005);
}

// By hand: differences 1, 2, 3, 4 and 5 of five groups in one stretch. Their sum is 15, and the sum
// of squares about the mean 10, of which 5/4 is 12.5.
TEST(PairedSquares, of_groups_alone) {
  PairedSquares squares(2, 5, 1);
  for (std::size_t g = 0; g < 5; ++g) squares.add(g, 0, {static_cast<double>(g + 2), 1});
  const SquaredDifference difference = squares.difference(0, 1);
  EXPECT_EQ(difference.mean, 3);
  EXPECT_NEAR(difference.t, 15 / std::sqrt(12.5), 1e-12);
  EXPECT_TRUE(difference.is_told);
  EXPECT_TRUE(difference.is_more_than_chance());
  EXPECT_NEAR(squares.difference(1, 0).t, -difference.t, 1e-12);
  EXPECT_TRUE(squares.difference(1, 0).is_more_than_chance());
}

// A difference that all groups have in one storm alone is of one stretch in five, however many
// gauges stand in it.
TEST(PairedSquares, of_one_storm_are_chance) {
  PairedSquares squares(2, 30, 5);
  for (std::size_t g = 0; g < 30; ++g) {
    for (std::size_t t = 0; t < 5; ++t) squares.add(g, t, {t == 2 ? 10.0 : 0.0, 0});
  }
  EXPECT_FALSE(squares.difference(0, 1).is_more_than_chance());
  PairedSquares without_time(2, 30, 1);
  Seeded seeded;
  for (std::size_t g = 0; g < 30; ++g) without_time.add(g, 0, {seeded.uniform(9, 11), 0});
  EXPECT_TRUE(without_time.difference(0, 1).is_more_than_chance());
}

TEST(PairedSquares, of_few_groups_and_of_none_are_not_told) {
  PairedSquares few(2, 4, 9);
  for (std::size_t g = 0; g < 4; ++g) few.add(g, g, {5, 1});
  EXPECT_FALSE(few.difference(0, 1).is_told);
  EXPECT_FALSE(PairedSquares(2, 9, 9).difference(0, 1).is_told);
  PairedSquares alike(2, 9, 1);
  for (std::size_t g = 0; g < 9; ++g) alike.add(g, 0, {2, 2});
  EXPECT_FALSE(alike.difference(0, 1).is_told);
}

// Of estimates that are as good as each other one in twenty pairs differs by more than chance has.
TEST(PairedSquares, are_right_about_chance) {
  Seeded seeded;
  int wrong = 0;
  constexpr int rounds = 400;
  for (int round = 0; round < rounds; ++round) {
    PairedSquares squares(2, 20, 20);
    std::vector<double> of_group;
    for (int g = 0; g < 20; ++g) of_group.push_back(seeded.uniform(-1, 1));
    for (std::size_t t = 0; t < 20; ++t) {
      const double of_time = seeded.uniform(-1, 1);
      for (std::size_t g = 0; g < 20; ++g)
        squares.add(g, t, {4 + of_time + of_group[g] + seeded.uniform(-1, 1), 4});
    }
    if (squares.difference(0, 1).is_more_than_chance()) ++wrong;
  }
  EXPECT_GE(wrong, rounds / 100);
  EXPECT_LE(wrong, rounds / 10);
}

}  // namespace
}  // namespace thiessen

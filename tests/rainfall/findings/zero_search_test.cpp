#include "rainfall/findings/zero_search.h"

#include <gtest/gtest.h>

#include "rainfall/findings/ring_of_gauges.h"

namespace thiessen {
namespace {

class ZeroSearchTest : public ::testing::Test {
 protected:
  GaugeNeighbours ring_ = ring_of(5);
  ZeroSearch search_{ring_, 5};
  ShownSteps steps_{search_};
};

TEST_F(ZeroSearchTest, finds_nothing_where_all_neighbours_have_much) {
  steps_.show("a", {0, 5, 6, 7, 8, 9});
  ASSERT_EQ(steps_.found.size(), 1u);
  EXPECT_EQ(steps_.found[0].station, StationIndex{0});
  EXPECT_EQ(steps_.found[0].kind, FindingKind::zero);
  EXPECT_EQ(steps_.found[0].value, 0);
  EXPECT_EQ(steps_.found[0].expected, 7);
}

TEST_F(ZeroSearchTest, asks_four_neighbours_that_report) {
  steps_.show("a", {0, silent, 4.9, 7, 8, 9});
  EXPECT_TRUE(steps_.found.empty());
  steps_.show("b", {0, silent, 6, 7, 8, 9});
  EXPECT_EQ(steps_.found.size(), 1u);
  steps_.show("c", {0, silent, silent, 7, 8, 9});  // three are too few
  EXPECT_EQ(steps_.found.size(), 1u);
}

TEST_F(ZeroSearchTest, forgives_one_of_more_that_it_has_less) {
  for (std::size_t one = 1; one <= 5; ++one) {
    std::vector<double> readings{0, 5, 6, 7, 8, 9};
    readings[one] = 0.2;
    steps_.show("a", readings);
    EXPECT_EQ(steps_.found.size(), one);
  }
  steps_.found.clear();
  steps_.show("b", {0, 4.9, 4.9, 7, 8, 9});
  EXPECT_TRUE(steps_.found.empty());
  GaugeNeighbours wider = ring_of(6);
  ZeroSearch of_six(wider, 5);
  ShownSteps steps(of_six);
  steps.show("c", {0, 4.9, 6, 7, 8, 4.9, 9});  // though four have much
  EXPECT_TRUE(steps.found.empty());
}

TEST_F(ZeroSearchTest, does_not_forgive_a_dry_neighbour) {
  for (std::size_t one = 1; one <= 5; ++one) {
    std::vector<double> readings{0, 5, 6, 7, 8, 9};
    readings[one] = 0;
    steps_.show("a", readings);
    EXPECT_TRUE(steps_.found.empty());
  }
}

TEST_F(ZeroSearchTest, does_not_mind_silence_or_a_little_rain) {
  steps_.show("a", {silent, 5, 6, 7, 8, 9});
  steps_.show("b", {0.1, 5, 6, 7, 8, 9});
  EXPECT_TRUE(steps_.found.empty());
}

TEST_F(ZeroSearchTest, wants_four_neighbours) {
  steps_.show("a", {9, 0, 6, 7, 8, 9});  // gauge 1 borders on three
  EXPECT_TRUE(steps_.found.empty());
}

}  // namespace
}  // namespace thiessen

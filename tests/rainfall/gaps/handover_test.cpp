#include "rainfall/gaps/handover.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "rainfall/gaps/nine_gauges.h"

namespace thiessen {
namespace {

// The middle square falls to its four neighbours in triangles; those across corners get nothing.
TEST_F(NineGauges, middle_hands_a_quarter_to_each_side) {
  const Handover handover = handovers_.of(cells({4}));
  ASSERT_EQ(handover.size(), 8u);
  const std::vector<PlaceIndex> heirs = cells({1, 3, 5, 7});
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(handover[i].basin, 0u);
    EXPECT_EQ(handover[i].cell, heirs[i]);
    EXPECT_NEAR(handover[i].weight, 1.0 / 4, 1e-14);
    EXPECT_EQ(handover[4 + i].basin, 1u);
    EXPECT_EQ(handover[4 + i].cell, heirs[i]);
    EXPECT_NEAR(handover[4 + i].weight, 1.0 / 16, 1e-14);
  }
}

// With the southern row silent its ground goes north, column by column.
TEST_F(NineGauges, row_hands_over_to_the_next_one) {
  const Handover handover = handovers_.of(cells({0, 1, 2}));
  ASSERT_EQ(handover.size(), 3u);
  EXPECT_EQ(handover[0].cell, PlaceIndex{3});
  EXPECT_NEAR(handover[0].weight, 0.25 / 4, 1e-14);
  EXPECT_NEAR(handover[1].weight, 0.5 / 4, 1e-14);
  EXPECT_NEAR(handover[2].weight, 0.25 / 4, 1e-14);
}

TEST_F(NineGauges, all_together_hand_over_nothing) {
  EXPECT_TRUE(handovers_.of(cells({0, 1, 2, 3, 4, 5, 6, 7, 8})).empty());
}

TEST_F(NineGauges, full_weights_are_those_of_the_weighing) {
  const auto expected = weighing_.weights(ReportingStations(9, true), 1);
  const auto found = handovers_.full_weights();
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t b = 0; b < found.size(); ++b) {
    ASSERT_EQ(found[b].stations.size(), expected[b].stations.size());
    for (std::size_t i = 0; i < found[b].stations.size(); ++i) {
      EXPECT_EQ(found[b].stations[i].station, expected[b].stations[i].station);
      EXPECT_EQ(found[b].stations[i].weight, expected[b].stations[i].weight);
    }
  }
}

}  // namespace
}  // namespace thiessen

#include "rainfall/gaps/handover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "rainfall/gaps/handover_cache.h"

namespace thiessen {
namespace {

// Nine gauges on a grid of unit steps, numbered by rows from the south-west, and two basins: the
// middle gauge's cell, and all cells but for their outer halves.
class NineGauges : public testing::Test {
 protected:
  static std::vector<Station> stations() {
    std::vector<Station> stations;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column)
        stations.push_back({std::to_string(stations.size()), {1.0 * column, 1.0 * row}, 0});
    }
    return stations;
  }
  static std::vector<PlaceIndex> cells(std::vector<std::uint32_t> numbers) {
    std::vector<PlaceIndex> cells;
    for (const std::uint32_t n : numbers) cells.push_back(PlaceIndex{n});
    return cells;
  }

  const Network network_{stations(), Metric::planar};
  const std::vector<Basin> basins_{shapes::basin({{shapes::rectangle({0.5, 0.5}, {1.5, 1.5}), {}}}),
                                   shapes::basin({{shapes::rectangle({0, 0}, {2, 2}), {}}})};
  const Weighing weighing_{network_, basins_, Yardstick{Metric::planar, 1, 0.1}};
  const Handovers handovers_{weighing_, 1};
};

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

TEST_F(NineGauges, silent_cells_are_parted_into_components) {
  const auto components = components_of(cells({0, 2, 4, 5, 8}), handovers_.adjacency());
  // Diagonals of the grid are ties: which of them are neighbours is the tessellation's choice.
  std::size_t count = 0;
  for (const auto& component : components) {
    EXPECT_TRUE(std::is_sorted(component.begin(), component.end()));
    count += component.size();
  }
  EXPECT_EQ(count, 5u);
  const auto apart = components_of(cells({0, 2, 6, 8}), handovers_.adjacency());
  EXPECT_EQ(apart.size(), 4u);
  const auto row = components_of(cells({3, 4, 5}), handovers_.adjacency());
  ASSERT_EQ(row.size(), 1u);
  EXPECT_EQ(row[0], cells({3, 4, 5}));
}

TEST_F(NineGauges, cache_gives_the_same_whatever_it_keeps) {
  for (const std::size_t bytes : {std::size_t{0}, std::size_t{20000}, std::size_t{1} << 20}) {
    HandoverCache cache(handovers_, bytes);
    for (int round = 0; round < 3; ++round) {
      for (std::uint32_t first = 0; first < 9; ++first) {
        for (std::uint32_t second = first + 1; second < 9; ++second) {
          const auto component = cells({first, second});
          const Handover expected = handovers_.of(component);
          const auto found = cache.of(component);
          ASSERT_EQ(found->size(), expected.size());
          for (std::size_t i = 0; i < expected.size(); ++i) {
            EXPECT_EQ((*found)[i].cell, expected[i].cell);
            EXPECT_EQ((*found)[i].weight, expected[i].weight);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace thiessen

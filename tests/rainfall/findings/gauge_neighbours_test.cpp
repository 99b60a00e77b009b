#include "rainfall/findings/gauge_neighbours.h"

#include <gtest/gtest.h>

#include "rainfall/findings/ring_of_gauges.h"

namespace thiessen {
namespace {

std::vector<std::uint32_t> of(const GaugeNeighbours& neighbours, std::uint32_t gauge) {
  std::vector<std::uint32_t> found;
  for (const GaugeNeighbours::Neighbour& neighbour : neighbours.of(StationIndex{gauge}))
    found.push_back(static_cast<std::uint32_t>(neighbour.station));
  return found;
}

using Gauges = std::vector<std::uint32_t>;

TEST(GaugeNeighbours, are_those_across_a_border) {
  const GaugeNeighbours neighbours = ring_of(5);
  EXPECT_EQ(neighbours.gauges(), 6u);
  EXPECT_EQ(of(neighbours, 0), (Gauges{1, 2, 3, 4, 5}));
  EXPECT_EQ(of(neighbours, 1), (Gauges{0, 2, 5}));
  EXPECT_EQ(neighbours.pairs().size(), 10u);
}

TEST(GaugeNeighbours, know_their_pair_and_which_of_it_they_are) {
  const GaugeNeighbours neighbours = ring_of(5);
  for (std::uint32_t g = 0; g < 6; ++g) {
    for (const GaugeNeighbours::Neighbour& neighbour : neighbours.of(StationIndex{g})) {
      const GaugeNeighbours::Pair& pair = neighbours.pairs()[neighbour.pair];
      EXPECT_EQ(neighbour.is_second ? pair.second : pair.first, StationIndex{g});
      EXPECT_EQ(neighbour.is_second ? pair.first : pair.second, neighbour.station);
    }
  }
}

TEST(GaugeNeighbours, are_all_gauges_of_a_place_and_of_those_beside_it) {
  const Network network({{"a", {0, 0}}, {"b", {0, 0}}, {"c", {1, 0}}}, Metric::planar);
  const std::vector<StationBorder> borders{{StationIndex{0}, StationIndex{2}, 1}};
  const GaugeNeighbours neighbours(network, borders);
  EXPECT_EQ(of(neighbours, 0), (Gauges{1, 2}));
  EXPECT_EQ(of(neighbours, 1), (Gauges{0, 2}));
  EXPECT_EQ(of(neighbours, 2), (Gauges{0, 1}));
}

TEST(GaugeNeighbours, are_four_of_a_place_with_more) {
  const Network network(
      {{"a", {0, 0}}, {"b", {0, 0}}, {"c", {0, 0}}, {"d", {0, 0}}, {"e", {0, 0}}, {"f", {1, 0}}},
      Metric::planar);
  const std::vector<StationBorder> borders{{StationIndex{0}, StationIndex{5}, 1}};
  const GaugeNeighbours neighbours(network, borders);
  EXPECT_EQ(of(neighbours, 5), (Gauges{0, 1, 2, 3}));
  EXPECT_EQ(of(neighbours, 0), (Gauges{1, 2, 3, 5}));
  EXPECT_EQ(of(neighbours, 4), (Gauges{0, 1, 2, 3, 5}));  // though it stands for no other
}

}  // namespace
}  // namespace thiessen

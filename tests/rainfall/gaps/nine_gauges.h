#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "rainfall/gaps/handover.h"

namespace thiessen {

/// Nine gauges on a grid of unit steps, numbered by rows from the south-west, and two basins: the
/// middle gauge's cell, and all cells but for their outer halves.
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

}  // namespace thiessen

#pragma once

#include <cstddef>
#include <vector>

#include "rainfall/network/network.h"

namespace thiessen {

/// Places in the order in which Hilbert's curve through their box comes to them, so that each is
/// near the one before. Equally far ones stand in the order of their coordinates.
std::vector<PlaceIndex> along_hilbert_curve(const Network& network);

/// Groups of neighbouring places, as equal in number as can be, by place: 30 of a large network,
/// and of a small one so many that four places are in each, or as many as there are where these
/// would be fewer than five.
struct GaugeGroups {
  explicit GaugeGroups(const Network& network);
  std::size_t count = 0;
  std::vector<std::size_t> of_place;
};

}  // namespace thiessen

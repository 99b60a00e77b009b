#pragma once

#include <optional>
#include <span>
#include <vector>

#include "study/ruler.h"
#include "tessellation/place.h"

namespace thiessen {

/// How far the gauges of a network are from each other.
struct GaugeSpacing {
  /// The median length of the Delaunay edges between places; nothing where there is only one place.
  std::optional<double> median_edge;
  /// The distance from each place to its nearest neighbour, by place; infinite for a single one.
  std::vector<double> to_nearest;
};

/// Measures the spacing by the Delaunay tessellation of the places; on the Earth by that of a
/// stereographic chart, which is the sphere's without the edges round its far side. Requires
/// different places. Cost: n log n.
GaugeSpacing spacing_of(std::span<const Point> places, const Ruler& ruler);

/// A gauge that is far from all others.
struct LonelyPlace {
  PlaceIndex place;
  double distance;  ///< to its nearest neighbour
};

/// The places that are far from all others, in their order: farther from the nearest one than five
/// times as far as four in five places are from theirs. Half of the places may stand in a town, and
/// one in five may be wrong, without hiding one that is far off. None where there are fewer than
/// three places.
std::vector<LonelyPlace> lonely_places(const GaugeSpacing& spacing);

}  // namespace thiessen

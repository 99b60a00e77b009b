#pragma once

#include <span>
#include <vector>

#include "basin/basin.h"
#include "earth/nearest/place_tree.h"
#include "study/ruler.h"

namespace thiessen {

/// The place of gauges that is nearest to a basin's outline.
struct NearestGauge {
  PlaceIndex place{0};
  double distance = 0;  ///< as Ruler::distance measures; from the outline, also for gauges inside
};

/// The nearest place to the outline of each basin, by basin.
///
/// The outline is walked along. Where the nearest place is at a distance d and the best so far at
/// b, nothing nearer can come within d - b, so so much of the outline is passed over. Hence few
/// points of a basin are looked at, however many vertices it has.
///
/// `enough`, where it is given, has a distance for each basin: its walk ends at a place that is no
/// farther, which need not be the nearest then.
///
/// Requires at least one place. Accuracy: a hundredth of the distance, which may be too long by so
/// much. Cost: linear in the vertices, 10 nanoseconds each, n log n in the places, and a search in
/// a tree for each stretch of the outline as long as its distance from the gauges.
std::vector<NearestGauge> nearest_gauges(std::span<const Point> places,
                                         std::span<const Basin> basins, const Ruler& ruler,
                                         std::span<const double> enough = {});

}  // namespace thiessen

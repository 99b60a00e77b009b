#pragma once

#include <memory>
#include <span>
#include <vector>

#include "earth/ground.h"
#include "tessellation/place.h"

namespace thiessen {

/// Finds the nearest of some places. Safe for several threads at once.
class NearestPlaces {
 public:
  virtual ~NearestPlaces() = default;
  /// Fills `nearest` with the place nearest to p, and with all that are as near.
  /// Planar: exact. Geodesic: by Karney's distances on WGS 84, which are right to 15 nanometres;
  /// equal where the doubles are. Cost: a walk from `hint`; geodesic also a distance, 1
  /// microsecond, for each place that is within 0.4 % as near as the nearest.
  virtual void find(Point p, PlaceIndex hint, std::vector<PlaceIndex>& nearest) const = 0;
};

/// Requires at least one place, different ones.
std::unique_ptr<NearestPlaces> nearest_places(std::span<const Point> places, Metric metric);

}  // namespace thiessen

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "earth/nearest/near_places.h"
#include "earth/nearest/place_tree.h"
#include "earth/yardstick.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// Finds the places nearest to a point by straight distance: in the plane, or through the Earth
/// between points of the ellipsoid. The latter ranks places as their geodesics do, unless these
/// differ by less than 30 metres at 1,000 km (see chord_bounds.h), or a thousandth of that at 100
/// km. Of equally near places the one with the lesser coordinates comes first. Safe for several
/// threads at once.
class NearestGauges {
 public:
  /// Requires at least one place, and all places different.
  NearestGauges(std::span<const Point> places, Metric metric);

  using Near = NearPlace;

  /// Finds up to `count` of the places that report, the nearest first. `reports` has one entry for
  /// each place; if it is empty, all report. `near` receives the result; if it holds what was found
  /// for a point near by, the search is faster, but it may hold anything. Cost: log n and the
  /// count, where places lie scattered and most of them report.
  void find(Point from, std::size_t count, const ReportingPlaces& reports,
            std::vector<Near>& near) const;

 private:
  std::vector<Point> places_;
  Metric metric_;
  std::unique_ptr<const PlaceTree> tree_;
};

}  // namespace thiessen

#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "earth/place_tree.h"
#include "earth/yardstick.h"
#include "rainfall/reporting.h"

namespace thiessen {

/// Finds the places nearest to a point, by straight distance: in the plane, or through the Earth
/// between points of the ellipsoid, which ranks places as their geodesics do but where these differ
/// by less than 30 metres at 1,000 km (see chord_bounds.h), a thousandth of that at 100. Of places
/// equally near that with the lesser coordinates comes first. Safe for several threads at once.
class NearestGauges {
 public:
  /// Requires at least one place, different ones.
  NearestGauges(std::span<const Point> places, Metric metric);

  struct Near {
    PlaceIndex place;
    double square;  ///< of the distance
  };

  /// Up to `count` places of those that report, the nearest first. `reports`: by place; empty: all
  /// do. `near`: what was found for a point near by, or anything; replaced. Cost: log n and the
  /// count where places lie scattered and most of them report.
  void find(Point from, std::size_t count, const ReportingPlaces& reports,
            std::vector<Near>& near) const;

 private:
  bool comes_before(const Near& a, const Near& b) const;

  std::vector<Point> places_;
  Metric metric_;
  std::unique_ptr<const PlaceTree> tree_;
};

}  // namespace thiessen

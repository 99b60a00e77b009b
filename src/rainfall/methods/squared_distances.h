#pragma once

#include <span>
#include <vector>

#include "earth/nearest/near_places.h"
#include "earth/sphere/geodesic.h"
#include "earth/yardstick.h"

namespace thiessen {

/// The squares of distances from a point to gauges that inverse distance weighs by: in the plane,
/// or of geodesics to 1e-7 of their length.
class SquaredDistances {
 public:
  SquaredDistances(std::span<const Point> gauges, Metric metric) {
    if (metric != Metric::geodesic) return;
    for (const Point p : gauges) on_earth_.emplace_back(p);
  }

  /// Finds that of each of the gauges near a point, whose own squares are those of NearestGauges.
  void from(Point point, std::span<const NearPlace> near, std::vector<double>& squares) const {
    constexpr double accuracy = 1;  // metres, of geodesics longer than 1,000 km
    squares.clear();
    for (const NearPlace& n : near) squares.push_back(n.square);
    if (on_earth_.empty()) return;
    const EarthPoint here(point);
    for (std::size_t k = 0; k < near.size(); ++k) {
      if (squares[k] == 0) continue;
      const double distance = arrival(on_earth_[index(near[k].place)], here, accuracy).distance;
      squares[k] = distance * distance;
    }
  }

 private:
  std::vector<EarthPoint> on_earth_;
};

}  // namespace thiessen

#pragma once

#include <optional>
#include <span>

#include "earth/conformal_sphere.h"
#include "earth/yardstick.h"

namespace thiessen {

/// Where a point lies in a GaugeChart.
struct ChartPoint {
  Point at;             ///< not finite at the point that the chart leaves out
  Direction direction;  ///< on the conformal sphere; of the plane: none
};

/// The plane in which the natural neighbours of a network's points are looked for. Planar: that of
/// the coordinates. Geodesic: the conformal sphere, seen from the middle of the largest gap between
/// gauges, in a stereographic chart: circles stay circles, so that the Delaunay triangulation in
/// the chart is the sphere's, with the middle of that gap for one gauge more, at infinity. For a
/// network smaller than a hemisphere that is the antipode of the middle of the smallest circle
/// round it; so its hull in the chart is bounded by circles through that antipode, which for a
/// network of a country are nearly great circles. Where gauges stand all round the Earth only what
/// lies round the middle of their largest gap is outside.
class GaugeChart {
 public:
  /// Requires different places, at least one. Cost: n log n.
  GaugeChart(std::span<const Point> places, Metric metric);

  bool is_of_earth() const { return stereographic_.has_value(); }
  ChartPoint at(Point position) const;

 private:
  std::optional<StereographicChart> stereographic_;
};

}  // namespace thiessen

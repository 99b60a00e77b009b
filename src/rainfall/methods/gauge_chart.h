#pragma once

#include <optional>
#include <span>

#include "earth/sphere/conformal_sphere.h"
#include "earth/yardstick.h"

namespace thiessen {

/// The place of a point in a GaugeChart.
struct ChartPoint {
  Point at;             ///< not finite at the point that the chart leaves out
  Direction direction;  ///< on the conformal sphere; unused in the plane
};

/// The plane in which the natural neighbours of a network's points are looked for.
///
/// Planar: the plane of the coordinates. Geodesic: a stereographic chart of the conformal sphere,
/// seen from the middle of the largest gap between gauges. The chart maps circles to circles. So
/// the Delaunay triangulation in the chart is the sphere's, with the middle of the gap as one more
/// gauge at infinity.
///
/// For a network smaller than a hemisphere the middle of the gap is the antipode of the centre of
/// the smallest circle round the network. So its hull in the chart is bounded by circles through
/// that antipode; for the network of a country these are nearly great circles. Where gauges stand
/// all round the Earth, only what lies round the middle of the largest gap is outside the hull.
class GaugeChart {
 public:
  /// Requires at least one place, and all places different. Cost: n log n.
  GaugeChart(std::span<const Point> places, Metric metric);

  bool is_of_earth() const { return stereographic_.has_value(); }
  ChartPoint at(Point position) const;

 private:
  std::optional<StereographicChart> stereographic_;
};

}  // namespace thiessen

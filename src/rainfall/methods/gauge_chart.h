#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "earth/sphere/conformal_sphere.h"
#include "earth/yardstick.h"
#include "tessellation/place.h"

namespace thiessen {

/// The place of a point in a GaugeChart.
struct ChartPoint {
  Point at;             ///< not finite at the point that the chart leaves out
  Direction direction;  ///< on the conformal sphere; unused in the plane
};

/// What a chart of gauges is of, and so what its point at infinity is.
enum class ChartKind : std::uint8_t {
  plane,          ///< no gauge
  part_of_earth,  ///< the middle of the gap between the gauges, where there is none
  whole_earth,    ///< one of the gauges, for they stand all round
};

/// The plane in which the natural neighbours of a network's points are looked for.
///
/// Planar: the plane of the coordinates. Geodesic: a stereographic chart of the conformal sphere.
/// The chart maps circles to circles. So the Delaunay triangulation in the chart is the sphere's,
/// with the point from which it is seen as one more gauge at infinity.
///
/// Where a hemisphere has no gauge, the chart is seen from the middle of the largest gap between
/// them. For a network smaller than a hemisphere that is the antipode of the centre of the smallest
/// circle round the network. So its hull in the chart is bounded by circles through that antipode;
/// for the network of a country these are nearly great circles.
///
/// Where every hemisphere has a gauge there is no hull, for the triangles close round the Earth.
/// Then the chart is seen from the gauge that is the first by coordinates.
class GaugeChart {
 public:
  /// Requires at least one place, and all places different. Cost: n log n.
  GaugeChart(std::span<const Point> places, Metric metric);

  ChartKind kind() const { return kind_; }
  ChartPoint at(Point position) const;
  /// The point of the Earth, or of the plane, that lies there in the chart.
  ChartPoint found_at(Point in_chart) const;

 private:
  ChartKind kind_ = ChartKind::plane;
  std::optional<StereographicChart> stereographic_;
};

}  // namespace thiessen

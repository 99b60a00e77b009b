#pragma once

#include <optional>
#include <span>

#include "earth/gnomonic_chart.h"
#include "tessellation/diagram.h"

namespace thiessen {

/// Some ground of the Earth, and the chart it is looked at in.
struct ChartGround {
  const GnomonicChart& chart;
  double reach;  ///< from the chart's centre, in radians, at least as far as the ground; below 1
  Box frame;     ///< of the ground in longitude and latitude, as geodesic_diagram wants it
};

/// The same cells as geodesic_diagram's, for areas rather than to be looked at: in the coordinates
/// of a chart, each edge one chord, that carries the area between the two in Diagram::bulges. What
/// is out of reach is left out. None where the places do not span the sphere (one, two, or all on a
/// circle), or one is more than 80 degrees away from the chart's centre.
///
/// `accuracy`: of vertices, in metres, at least 1e-6. Accuracy: a chord's bulge 1e-3 of it, where
/// the edge is short against the Earth (250 metres of 100 km are off the chord); the chord itself
/// is off by the edge's own bend, 0.2 metres where gauges are 20 km away, and with the square of
/// that. Cost: n log n for n places; some ten distances for each vertex within the frame, and six
/// for each edge: 20 to 50 microseconds for seven places.
std::optional<Diagram> chart_diagram(std::span<const Point> places, const ChartGround& ground,
                                     double accuracy);

}  // namespace thiessen

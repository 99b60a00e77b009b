#pragma once

#include <optional>
#include <span>

#include "diagram/diagram.h"
#include "earth/gnomonic_chart.h"

namespace thiessen {

/// Some ground of the Earth, and the chart it is looked at in.
struct ChartGround {
  const GnomonicChart& chart;
  double reach;  ///< from the chart's centre, in radians, at least as far as the ground; below 1
  Box frame;     ///< of the ground in longitude and latitude, as geodesic_diagram wants it
};

/// In metres, at least 1e-6.
struct ChartAccuracy {
  double vertices;
  double bends;  ///< how far an edge may bend off its chord
};

/// The same cells as geodesic_diagram's, for areas rather than to be looked at: in the coordinates
/// of a chart, with few chords, each of which carries the area between the edge and it in
/// Diagram::bulges. What is out of reach is left out. None where the places do not span the sphere
/// (one, two, or all on a circle), or one is more than 80 degrees away from the chart's centre.
///
/// Edges bend by 0.2 metres where gauges are 20 km away, and with the square of that: most are one
/// chord there. Accuracy: a chord's bulge 1e-3 of it; what is cut off the edge, as if it bent like
/// a parabola, to a third of `bends`. Cost: n log n for n places; some ten distances for each
/// vertex within the frame, and six for each chord: 20 to 50 microseconds for seven places.
std::optional<Diagram> chart_diagram(std::span<const Point> places, const ChartGround& ground,
                                     const ChartAccuracy& accuracy);

}  // namespace thiessen

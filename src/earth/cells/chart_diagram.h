#pragma once

#include <optional>
#include <span>

#include "diagram/diagram.h"
#include "earth/sphere/gnomonic_chart.h"

namespace thiessen {

/// A region of the Earth and the gnomonic chart in which it is measured.
struct ChartGround {
  const GnomonicChart& chart;
  double reach;  ///< radians from the chart's centre, at least to the region's edge; below 1
  Box frame;     ///< longitude and latitude of the region, as geodesic_diagram requires
};

/// The accuracy asked of a chart's diagram, in metres; each figure is at least 1e-6.
struct ChartAccuracy {
  double vertices;
  double bends;  ///< how far an edge may bend off its chord
};

/// The Thiessen cells of geodesic_diagram in the coordinates of a chart, made for computing areas
/// rather than for drawing. They have few chords; each carries the area between the true edge and
/// itself in Diagram::bulges. Edges out of reach are left out. The result is empty where the places
/// do not span the sphere (one, two, or all on a circle), or where one is more than 80 degrees away
/// from the chart's centre.
///
/// An edge between gauges 20 km apart bends by 0.2 metres, and the bend grows with the square of
/// the distance, so most edges are one chord there. Accuracy: a chord's bulge is right to 1e-3 of
/// itself; areas that are cut off an edge treat it as a parabola, which is right to a third of
/// `bends`. Cost: n log n for n places; some ten distances for each vertex within the frame, and
/// six for each chord: 20 to 50 microseconds for seven places.
std::optional<Diagram> chart_diagram(std::span<const Point> places, const ChartGround& ground,
                                     const ChartAccuracy& accuracy);

}  // namespace thiessen

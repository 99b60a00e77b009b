#pragma once

#include <string>

#include "map/sheet/picture.h"

namespace thiessen {

/// The map as elements of an SVG, `<svg id="map">`: a path a cell with its station and basin, the
/// outlines of basins, and dots for gauges.
///
/// Coordinates are whole numbers, of which the map has 10,000 along its wider side, a tenth of a
/// pixel where it is shown 1,000 pixels wide. Neighbours are rounded alike, so no gap opens between
/// them. A cell that the antimeridian cuts has its outline as a path of its own, without the cut.
/// What a script needs beside them stands in the order of the picture's cells.
std::string report_map(const Picture& picture);

}  // namespace thiessen

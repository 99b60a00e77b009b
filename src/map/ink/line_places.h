#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"

namespace thiessen {

/// The middles of the stretches of a line over which a text of this width may stand, the
/// straightest and most level first: of stretches equally good to an eighth, the first along the
/// line. None where the line is not twice as long as the text, which would hide most of it. Cost:
/// the vertices, and sorting four places for each width of the line's length.
std::vector<Point> text_places(std::span<const Point> line, double width);

}  // namespace thiessen

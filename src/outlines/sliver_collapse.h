#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// Lets what is narrower than `grid` fall together in the cells of one basin: needles, slivers, and
/// rings that rounding made cross themselves.
///
/// Vertices and crossings move to multiples of the grid, and edges that pass one of them within
/// half of it are led through it, for all cells alike; each piece of ground that is left goes to
/// the cell that held it (where two did, to the first). So cells stay beside each other without gap
/// or overlap, share their edges vertex for vertex, and are valid shapes. A vertex to which nothing
/// fell keeps its bits where the cells stay valid so. A cell that is narrower than the grid as a
/// whole has no shape in the result.
///
/// The result is empty where the ground would change by more than a hundred times the grid along
/// the cells' outlines: then more than slivers is wrong. Requires finite coordinates, outer rings
/// counter-clockwise and holes clockwise. Cost: n log n.
std::optional<std::vector<MultiPolygon>> collapsed(std::span<const MultiPolygon> cells,
                                                   double grid);

}  // namespace thiessen

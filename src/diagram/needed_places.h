#pragma once

#include <span>
#include <vector>

#include "geometry/point.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Which places may have a cell in the plane that meets some ground: an entry for each place, false
/// only where the cell is certain to lie apart from all of the ground, and its distance from there
/// is more than rounding. The list is empty where that is not worth knowing, because there are few
/// places, most of their surroundings are ground, or rounding is not small beside their distances.
///
/// The plane is laid out in squares, four places each on the whole. Any point of a square has a
/// place within so many squares as the nearest that holds one is away, so the place that is nearest
/// to the point is at most the diagonal of these squares away. Cost: linear in the places and the
/// outlines.
std::vector<bool> needed_places(std::span<const Point> places,
                                std::span<const MultiPolygon* const> ground);

}  // namespace thiessen

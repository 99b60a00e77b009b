#pragma once

#include <span>

#include "diagram/dual.h"
#include "geometry/point.h"

namespace thiessen {

/// The dual of geodesic_diagram's cells, of the whole Earth: no border is without end, and those of
/// the outermost places of a network lead round to its far side. Borders are in metres, along the
/// curve of equal geodesic distances. Where vertices are one in geodesic_diagram, because distances
/// cannot tell them apart, the border between them has no length and is left out; so is one of up
/// to twenty times the accuracy, which may be none: its ends are right to ten times as much each.
///
/// A triangle has its corners counter-clockwise, seen from above. Three places that make one only
/// if it is turned over, because their cells meet on the far side of the Earth, make none, and
/// neither do three on one great circle to within a micrometre. Places that rounding cannot tell
/// from others (Diagram::cell_of) have neither borders nor triangles.
///
/// Requires at least one place, different ones. `accuracy`: of the vertices, in metres, at least
/// 1e-6. The result does not depend on `threads`. Cost: n log n; some ten geodesics for each vertex
/// and, for borders up to 100 km, for each border.
Dual geodesic_dual(std::span<const Point> places, double accuracy, unsigned threads);

}  // namespace thiessen

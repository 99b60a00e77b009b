#pragma once

#include <span>

#include "diagram/dual.h"
#include "geometry/point.h"

namespace thiessen {

/// The dual of plane_diagram's cells. Borders are as long as the plane's unit says, and those of
/// places on the hull never end. Where vertices are one in plane_diagram, because rounding cannot
/// tell them apart, the border between them has no length and is left out. Places on one line have
/// borders, but no triangles.
///
/// Requires different places in the exact range of predicates.h. Accuracy: lengths are right to a
/// few times 2^-52 of themselves, however near their ends are to each other. Cost: n log n.
Dual plane_dual(std::span<const Point> places);

}  // namespace thiessen

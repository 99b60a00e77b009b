#pragma once

#include "geometry/polygon.h"

namespace thiessen {

/// The area of a ring in the coordinates' plane, positive where it runs counter-clockwise.
/// Accuracy: 1e-15 of the sum of its terms, which are taken relative to the first point.
double signed_area(const Ring& ring);

/// Makes outer rings run counter-clockwise and holes clockwise; each ring keeps its first point.
void turn_rings(MultiPolygon& shape);

}  // namespace thiessen

#pragma once

#include "geometry/polygon.h"

namespace thiessen {

/// Whether all of a ring is seen, in its order and counter-clockwise, from the mean of its corners.
/// A ring of which this is true bounds a valid polygon: no edge crosses or touches another. It is
/// true of convex rings, as of cells in a plane, but for those that rounding has folded or that are
/// narrower than it. Exact. Cost: linear.
bool is_star_shaped(const Ring& ring);

}  // namespace thiessen

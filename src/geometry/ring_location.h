#pragma once

#include "geometry/box.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Where a point lies with respect to a ring.
enum class Where { outside, boundary, inside };

/// Whether the point is outside, on or inside the ring, exactly. Cost: in proportion to the ring's
/// vertices.
Where locate(const Ring& ring, Point p);

/// The smallest box that contains the ring.
Box box_of(const Ring& ring);

}  // namespace thiessen

#pragma once

#include "geometry/box.h"
#include "geometry/polygon.h"

namespace thiessen {

enum class Where { outside, boundary, inside };

/// Where the point lies against the ring, exactly. Cost: the ring's vertices.
Where locate(const Ring& ring, Point p);

Box box_of(const Ring& ring);

}  // namespace thiessen

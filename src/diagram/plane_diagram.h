#pragma once

#include <span>

#include "diagram/diagram.h"

namespace thiessen {

/// The Thiessen cells of `places` in the plane, where the nearest place is nearest by straight
/// distance. Edges are cut off a little outside `frame`. Nodes at which four or more cells meet are
/// one node, and so are neighbouring nodes that rounding cannot tell apart: no edge has length
/// zero.
/// Requires different places in the exact range of predicates.h, and a frame that is not empty.
/// Accuracy: the nodes are within 2^-47 of the distance from their places, plus the rounding to
/// doubles. Cost: n log n for n places.
Diagram plane_diagram(std::span<const Point> places, const Box& frame);

}  // namespace thiessen

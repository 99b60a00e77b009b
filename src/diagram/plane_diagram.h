#pragma once

#include <span>
#include <vector>

#include "diagram/diagram.h"
#include "geometry/polygon.h"

namespace thiessen {

/// What a diagram of the plane is needed for. Less takes less time and memory, and what is there is
/// the same.
struct PlaneNeeds {
  /// The shapes that are laid over the cells: edges of cells that meet none of them may be left
  /// out. Where there are none, all edges near the frame are there. They are not looked at again
  /// once the diagram is made.
  std::vector<const MultiPolygon*> ground;
  bool neighbours = true;  ///< else Diagram::neighbours is empty
  /// Whether Diagram::near is called so seldom that it may take as long as there are places. Then
  /// the tessellation, 72 bytes a place, is not kept for it.
  bool near_is_seldom = false;
};

/// The Thiessen cells of `places` in the plane, where the nearest place is nearest by straight
/// distance. Edges are cut off a little outside `frame`. Nodes at which four or more cells meet are
/// one node, and so are neighbouring nodes that rounding cannot tell apart: no edge has length
/// zero.
/// Requires different places in the exact range of predicates.h, and a frame that is not empty.
/// Accuracy: the nodes are within 2^-47 of the distance from their places, plus the rounding to
/// doubles. Cost: n log n for n places; centres and edges only of what is needed.
Diagram plane_diagram(std::span<const Point> places, const Box& frame,
                      const PlaneNeeds& needs = {});

}  // namespace thiessen

#pragma once

#include <vector>

#include "geometry/coordinates.h"
#include "map/plot/scene_coordinates.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// From one place to another, in SceneCoordinates.
template <int Dimension>
struct EdgeIn {
  CoordinatesIn<Dimension> from;
  CoordinatesIn<Dimension> to;
};

/// A tessellation's edges as far as they lie in a box about the middle of SceneCoordinates.
template <int Dimension>
struct TessellationEdges {
  /// Unbounded ones end at the box. Those that a tie makes a point are left out, exactly.
  std::vector<EdgeIn<Dimension>> voronoi;
  /// Each from its lexicographically first point to the other, those that a tie alone decides
  /// among them. Not cut.
  std::vector<EdgeIn<Dimension>> delaunay;
  /// In space, where the points lie in a plane or on a line: where the walls between the cells,
  /// which then have no vertices, leave the box.
  std::vector<EdgeIn<Dimension>> rims;
};

/// The edges in the box of the given half sides. They do not depend on the order in which the
/// points came, but for their own order. A Voronoi edge lies on the line through the middle of its
/// points (in space: through the nearest known of its line's places), so that far vertices do not
/// turn it. Cost: linear in the simplices.
TessellationEdges<2> edges_in_box(const Tessellation<2>& tessellation,
                                  const SceneCoordinates<2>& scene, const CoordinatesIn<2>& half);
TessellationEdges<3> edges_in_box(const Tessellation<3>& tessellation,
                                  const SceneCoordinates<3>& scene, const CoordinatesIn<3>& half);

}  // namespace thiessen

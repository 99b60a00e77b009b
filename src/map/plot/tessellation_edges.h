#pragma once

#include <vector>

#include "geometry/coordinates.h"
#include "map/plot/scene_coordinates.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// An edge from one place to another, in SceneCoordinates.
template <int Dimension>
struct EdgeIn {
  CoordinatesIn<Dimension> from;
  CoordinatesIn<Dimension> to;
};

/// The edges of a tessellation as far as they lie in a box about the middle of SceneCoordinates.
template <int Dimension>
struct TessellationEdges {
  /// Voronoi edges. Unbounded ones end at the box. Edges that a tie shrinks to a point are left
  /// out, which is decided exactly.
  std::vector<EdgeIn<Dimension>> voronoi;
  /// Delaunay edges, including those that only the rule for ties chooses. Each leads from its
  /// lexicographically first point to the other, and is not cut to the box.
  std::vector<EdgeIn<Dimension>> delaunay;
  /// The lines along which the walls between cells leave the box. They are given in space, where
  /// the points lie in a plane or on a line: cells then have no vertices.
  std::vector<EdgeIn<Dimension>> rims;
};

/// Finds the edges in the box of the given half sides. Apart from their own order they do not
/// depend on the order in which the points came. A Voronoi edge lies on the line through the middle
/// of its points (in space: through the nearest known place of its line), so that vertices far away
/// do not turn it. Cost: linear in the simplices.
TessellationEdges<2> edges_in_box(const Tessellation<2>& tessellation,
                                  const SceneCoordinates<2>& scene, const CoordinatesIn<2>& half);
TessellationEdges<3> edges_in_box(const Tessellation<3>& tessellation,
                                  const SceneCoordinates<3>& scene, const CoordinatesIn<3>& half);

}  // namespace thiessen

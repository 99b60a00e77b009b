#pragma once

#include "geometry/point.h"
#include "tessellation/structure.h"

namespace thiessen {

/// A vertex of the Voronoi tessellation: the centre and the radius of the circle or sphere through
/// its forming points. Both are computed from the points in the order of their coordinates, so that
/// the same points give the same bits.
template <int Dimension>
struct VoronoiVertex {
  VertexId vertex;
  PositionIn<Dimension> centre;
  double radius;
};

/// Computes the centre and the radius of a vertex. Requires that the points span the plane or
/// space, and a vertex without the infinite point. Accuracy: see circumcentre and circumradius. The
/// centre is infinite where it is beyond the doubles, that is, for points that are on a line or
/// plane but for 1e-150 of their distances.
template <int Dimension>
VoronoiVertex<Dimension> voronoi_vertex(const Structure<Dimension>& structure, VertexId v);

}  // namespace thiessen

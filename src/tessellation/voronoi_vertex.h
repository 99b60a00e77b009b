#pragma once

#include "geometry/point.h"
#include "tessellation/structure.h"

namespace thiessen {

/// A vertex of the Voronoi tessellation: the centre and the radius of its forming points' circle or
/// sphere, computed in the order of their coordinates, so that the same points give the same bits.
template <int Dimension>
struct VoronoiVertex {
  VertexId vertex;
  PositionIn<Dimension> centre;
  double radius;
};

/// Requires that the points span the plane or space, and a vertex without the infinite point.
/// Accuracy: see circumcentre and circumradius. Beyond the doubles (points that are a line or plane
/// but for 1e-150 of their distances) the centre is infinite.
template <int Dimension>
VoronoiVertex<Dimension> voronoi_vertex(const Structure<Dimension>& structure, VertexId v);

}  // namespace thiessen

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tessellation/tessellation.h"
#include "tessellation/voronoi_vertex.h"

namespace thiessen {

/// A point's Voronoi cell. Vertices that coincide, exactly, are one vertex here, named by the one,
/// of those that the point forms, whose forming points come first by coordinates. Neighbours are
/// the points with whose cells an edge (in space a face) is shared that is more than a vertex: no
/// tie-break shows, and the same points give the same cells. Where the points span less than the
/// plane or space, cells are strips or prisms: they have neighbours, but neither vertices nor rays.

/// An edge that never ends: from one of the cell's vertices, in a direction of length 1.
template <int Dimension>
struct CellRay {
  std::size_t from;  ///< in the cell's vertices
  PositionIn<Dimension> direction;
};

struct PlaneCell {
  PointId point;
  bool is_bounded = false;
  /// Counter-clockwise: of a bounded cell from the first by coordinates, of an unbounded one from
  /// ray to ray.
  std::vector<VoronoiVertex<2>> vertices;
  std::vector<CellRay<2>> rays;  ///< of an unbounded cell the first edge, and the last
  /// Counter-clockwise; on a line from the first by coordinates. The edge shared with
  /// neighbours[i] ends at vertices[i] and begins at the one before.
  std::vector<PointId> neighbours;
  double area = std::numeric_limits<double>::infinity();
};

/// What two cells in space share.
struct CellFace {
  PointId neighbour;
  bool is_bounded = false;
  /// In the cell's vertices; counter-clockwise as seen from the neighbour, of an unbounded face
  /// from ray to ray.
  std::vector<std::size_t> vertices;
  double area = std::numeric_limits<double>::infinity();
};

struct SpaceCell {
  PointId point;
  bool is_bounded = false;
  std::vector<VoronoiVertex<3>> vertices;  ///< in the order of their coordinates
  std::vector<CellRay<3>> rays;            ///< in the order of their vertices
  std::vector<CellFace> faces;             ///< in the order of the neighbours' coordinates
  double volume = std::numeric_limits<double>::infinity();
};

/// The cell of a point that is there. Accuracy of area and volume: a sum of positive terms, each
/// computed from exact determinants, so 1e-14 of itself for any shape in the plane; in space that
/// times the ratio of a face's diameter to its width. Cost: that of the vertices; a few
/// microseconds in the plane, about a hundred in space.
PlaneCell find_cell(const Tessellation<2>& tessellation, PointId p);
SpaceCell find_cell(const Tessellation<3>& tessellation, PointId p);

}  // namespace thiessen

#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "tessellation/tessellation.h"
#include "tessellation/voronoi_vertex.h"

namespace thiessen {

/// This file describes the Voronoi cell of a point. Vertices that coincide exactly are one vertex
/// here. It is named by one of those that the point forms: the one whose forming points come first
/// by coordinates. Neighbours are the points whose cells share an edge with this cell (in space a
/// face) that is more than a vertex. So no tie-break shows, and the same points give the same
/// cells. Where the points span less than the plane or space, cells are strips or prisms: they have
/// neighbours, but neither vertices nor rays.

/// An edge of a cell that never ends: it starts at one of the cell's vertices and has a direction
/// of length 1.
template <int Dimension>
struct CellRay {
  std::size_t from;  ///< index into the cell's vertices
  PositionIn<Dimension> direction;
};

/// The Voronoi cell of a point in the plane.
struct PlaneCell {
  PointId point;
  bool is_bounded = false;
  /// The vertices, counter-clockwise. A bounded cell begins with the first of them by coordinates;
  /// an unbounded one goes from ray to ray.
  std::vector<VoronoiVertex<2>> vertices;
  std::vector<CellRay<2>> rays;  ///< the first and the last edge of an unbounded cell
  /// The neighbours, counter-clockwise; on a line in the order of their coordinates. The edge
  /// shared with neighbours[i] begins at the vertex before vertices[i], and ends at vertices[i].
  std::vector<PointId> neighbours;
  double area = std::numeric_limits<double>::infinity();
};

/// The face that a cell in space shares with a neighbour's.
struct CellFace {
  PointId neighbour;
  bool is_bounded = false;
  /// The face's vertices, as indices into the cell's vertices; counter-clockwise as seen from the
  /// neighbour. Those of an unbounded face go from ray to ray.
  std::vector<std::size_t> vertices;
  double area = std::numeric_limits<double>::infinity();
};

/// The Voronoi cell of a point in space.
struct SpaceCell {
  PointId point;
  bool is_bounded = false;
  std::vector<VoronoiVertex<3>> vertices;  ///< in the order of their coordinates
  std::vector<CellRay<3>> rays;            ///< in the order of their vertices
  std::vector<CellFace> faces;             ///< in the order of the neighbours' coordinates
  double volume = std::numeric_limits<double>::infinity();
};

/// Finds the Voronoi cell of p. Requires that p is there.
/// Accuracy of area and volume: each is a sum of positive terms that are computed from exact
/// determinants. The relative error is 1e-14 for any shape in the plane; in space it is that times
/// the ratio of a face's diameter to its width.
/// Cost: in proportion to the vertices; a few microseconds in the plane, about a hundred in space.
PlaneCell find_cell(const Tessellation<2>& tessellation, PointId p);
SpaceCell find_cell(const Tessellation<3>& tessellation, PointId p);

}  // namespace thiessen

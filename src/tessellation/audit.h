#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// What can be wrong with a tessellation.
enum class Fault : std::uint8_t {
  // Links: a closed surface, without coordinates.
  repeated_forming_point,  ///< a simplex has a point twice
  link_to_nothing,         ///< a neighbour is missing, freed or no vertex at all
  link_not_returned,       ///< the neighbour does not have this vertex for its own
  edge_not_shared,         ///< neighbours that do not have the edge between them in common
  point_without_simplex,   ///< the simplex noted for a point is not one of its own
  surface_not_a_sphere,    ///< not 2 (points + 1) - 4 simplices, or not all reached from the first
  // The plane: the simplices tile the convex hull.
  simplex_not_left_turning,  ///< clockwise or flat
  hull_not_convex,           ///< the hull turns right at a point
  hull_winds_again,          ///< the hull goes round more than once
  // Circles: the Delaunay property, exactly.
  point_in_circle,       ///< the circle of a simplex holds the point across from it
  tie_broken_otherwise,  ///< four points on a circle, with the other diagonal
  // The line.
  points_out_of_order,
  point_off_line,
};

/// The fault's name in words.
std::string_view name_of(Fault fault);

struct Finding {
  Fault fault;
  VertexId vertex;  ///< at which it shows; no_vertex on a line
  Point place;      ///< a forming point there
};

/// What is wrong, in layers, each resting on the one before it: the links; orientation and hull;
/// empty circles. A layer is looked at only where those below it are sound. Nothing is found in a
/// Tessellation, unless it has a bug. Cost: linear; exact predicates throughout.
std::vector<Finding> audit(const Tessellation& tessellation);

/// The layers alone, for a topology over points at `positions`. Each requires that those before it
/// find nothing.
std::vector<Finding> audit_links(const Topology<2>& topology, std::span<const Point> positions);
std::vector<Finding> audit_plane(const Topology<2>& topology, std::span<const Point> positions);
std::vector<Finding> audit_circles(const Topology<2>& topology, std::span<const Point> positions);

}  // namespace thiessen

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "tessellation/structure.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// What can be wrong with a tessellation.
enum class Fault : std::uint8_t {
  free_twice_or_lost,  ///< the chain of freed rows, or the count of points, is not what is in use
  // Links: a closed surface (in space its like one dimension up), without coordinates.
  repeated_forming_point,  ///< a simplex has a point twice, or one that is not there
  link_to_nothing,         ///< a neighbour is missing, freed or no vertex at all
  link_not_returned,       ///< the neighbour does not have this vertex for its own
  facet_not_shared,        ///< neighbours that do not have the facet between them in common
  point_without_simplex,   ///< the simplex noted for a point is not one of its own
  number_of_simplices,     ///< not as many as points and edges ask for, or a point is in none
  in_pieces,               ///< not all are reached from the first
  // Orientation and hull: the simplices tile the convex hull.
  simplex_turned_over,  ///< or flat
  hull_not_convex,      ///< two facets of the hull meet at an angle turned inwards
  hull_winds_again,     ///< the hull goes round more than once
  point_off_span,       ///< a point that is not on the line or plane of the others
  // Empty circles and spheres: the Delaunay property, exactly.
  point_in_sphere,       ///< the sphere of a simplex holds the point across from it
  tie_broken_otherwise,  ///< points on one sphere, divided otherwise
};

/// The fault's name in words.
std::string_view name_of(Fault fault);

template <int Dimension>
struct Finding {
  Fault fault;
  VertexId vertex;                 ///< at which it shows; no_vertex where it shows at a point
  PositionIn<Dimension> position;  ///< of a forming point there
};

/// What is wrong, in layers, each resting on the one before it: the links; orientation and hull;
/// empty circles or spheres. A layer is looked at only where those below it are sound. Nothing is
/// found in a Tessellation, unless it has a bug. Cost: linear; exact predicates throughout.
template <int Dimension>
std::vector<Finding<Dimension>> audit(const Structure<Dimension>& structure);
template <int Dimension>
std::vector<Finding<Dimension>> audit(const Tessellation<Dimension>& tessellation) {
  return audit(tessellation.structure());
}

/// The layers alone. Each requires that those before it find nothing.
template <int Dimension>
std::vector<Finding<Dimension>> audit_links(const Structure<Dimension>& structure);
template <int Dimension>
std::vector<Finding<Dimension>> audit_hull(const Structure<Dimension>& structure);
template <int Dimension>
std::vector<Finding<Dimension>> audit_spheres(const Structure<Dimension>& structure);

}  // namespace thiessen

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "tessellation/structure.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// A fault that a tessellation can have, in three layers.
enum class Fault : std::uint8_t {
  free_twice_or_lost,  ///< the free rows or the count of points do not match those in use
  // Layer 1, links: without looking at coordinates, the simplices must form a closed surface (in
  // space its three-dimensional counterpart).
  repeated_forming_point,  ///< a simplex has a point twice, or one that is not there
  link_to_nothing,         ///< a neighbour is missing, freed or no vertex at all
  link_not_returned,       ///< the neighbour does not have this vertex for its own
  facet_not_shared,        ///< two neighbours do not have the facet between them in common
  point_without_simplex,   ///< the simplex noted for a point is not one of its own
  number_of_simplices,     ///< the points and edges ask for another number, or a point is in none
  in_pieces,               ///< not all simplices are reached from the first
  // Layer 2, orientation and hull: the simplices must tile the convex hull.
  simplex_turned_over,  ///< a simplex is turned over, or flat
  hull_not_convex,      ///< two facets of the hull meet at an angle turned inwards
  hull_winds_again,     ///< the hull goes round more than once
  point_off_span,       ///< a point that is not on the line or plane of the others
  // Layer 3, empty circles and spheres: the Delaunay property must hold exactly.
  point_in_sphere,       ///< the sphere of a simplex holds the point across from it
  tie_broken_otherwise,  ///< points on one sphere are divided otherwise than the tie-break says
};

/// The fault's name in plain words.
std::string_view name_of(Fault fault);

/// A fault that was found, and where it was found.
template <int Dimension>
struct Finding {
  Fault fault;
  VertexId vertex;  ///< the vertex where it shows; no_vertex where it shows at a point
  PositionIn<Dimension> position;  ///< the position of a forming point there
};

/// Finds what is wrong with the structure. The checks are in layers: the links; orientation and
/// hull; empty circles or spheres. Each layer rests on the ones before it, and is checked only
/// where these are sound. A Tessellation has no findings unless it has a bug. Cost: linear; exact
/// predicates throughout.
template <int Dimension>
std::vector<Finding<Dimension>> audit(const Structure<Dimension>& structure);
template <int Dimension>
std::vector<Finding<Dimension>> audit(const Tessellation<Dimension>& tessellation) {
  return audit(tessellation.structure());
}

/// Checks the links alone.
template <int Dimension>
std::vector<Finding<Dimension>> audit_links(const Structure<Dimension>& structure);
/// Checks orientation and hull alone. Requires that audit_links finds nothing.
template <int Dimension>
std::vector<Finding<Dimension>> audit_hull(const Structure<Dimension>& structure);
/// Checks the empty circles or spheres alone. Requires that audit_links and audit_hull find
/// nothing.
template <int Dimension>
std::vector<Finding<Dimension>> audit_spheres(const Structure<Dimension>& structure);

}  // namespace thiessen

#pragma once

#include <optional>
#include <span>
#include <vector>

#include "tessellation/structure.h"

namespace thiessen {

/// A vertex with the number and the order of forming points that it is to have.
template <int Dimension>
struct ArrangedVertex {
  VertexId vertex;
  typename Topology<Dimension>::Forming forming;
};

/// Arranges the table of a structure as another table of the same points is: gives its finite
/// vertices their numbers and the order of their forming points. The order in which points came and
/// went shows in nothing else, so afterwards both tables are printed alike. Vertices with the
/// infinite point take numbers that are left, the lowest first; what remains is free.
///
/// Returns the position in `vertices` of one that the structure does not have, that stands there
/// twice, or whose forming points are turned over; `vertices.size()` where one of the structure's
/// is not among them; nothing where all went well. The structure is unchanged where it does not.
/// Requires points that span the space, which nobody records, and vertex numbers below
/// arrangement_limit. Cost: n log n.
template <int Dimension>
std::optional<std::size_t> arrange_vertices(Structure<Dimension>& structure,
                                            std::span<const ArrangedVertex<Dimension>> vertices);

/// The numbers of vertices that an arrangement of so many may have lie below this: a table of rows
/// is as long as its largest number says. After most points of a session are deleted, numbers are
/// as sparse as the limit allows.
constexpr std::size_t arrangement_limit(std::size_t vertices) {
  return 64 * vertices + (std::size_t{1} << 20);
}

}  // namespace thiessen

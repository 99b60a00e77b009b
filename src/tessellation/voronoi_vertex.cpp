#include "tessellation/voronoi_vertex.h"

#include <cstddef>

#include "geometry/predicates.h"
#include "geometry/space_predicates.h"
#include "geometry/voronoi_measures.h"

namespace thiessen {

template <int Dimension>
VoronoiVertex<Dimension> voronoi_vertex(const Structure<Dimension>& structure, VertexId v) {
  const auto at = [&](std::size_t i) -> const PositionIn<Dimension>& {
    return structure.position(structure.topology().forming(v)[i]);
  };
  if constexpr (Dimension == 2) {
    return {v, circumcentre(at(0), at(1), at(2)), circumradius(at(0), at(1), at(2))};
  } else {
    return {v, circumcentre(at(0), at(1), at(2), at(3)), circumradius(at(0), at(1), at(2), at(3))};
  }
}

template VoronoiVertex<2> voronoi_vertex(const Structure<2>&, VertexId);
template VoronoiVertex<3> voronoi_vertex(const Structure<3>&, VertexId);

}  // namespace thiessen

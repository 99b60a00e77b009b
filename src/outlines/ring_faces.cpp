#include "outlines/ring_faces.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.h"
#include "basin/ring_linking.h"
#include "outlines/geos.h"
#include "outlines/polygon_validity.h"
#include "outlines/ring_direction.h"

namespace thiessen {
namespace {

void require(bool done, const Geos& geos) {
  if (!done) throw Error({"", 0, "GEOS cannot part a shape along its edges: " + geos.text(), ""});
}

Point point_in(const Geos& geos, const GEOSGeometry* face) {
  const Geos::Shape point = geos.own(GEOSPointOnSurface_r(geos.context(), face));
  Point within;
  require(point != nullptr && GEOSGeomGetX_r(geos.context(), point.get(), &within.x) == 1 &&
              GEOSGeomGetY_r(geos.context(), point.get(), &within.y) == 1,
          geos);
  return within;
}

void add_edges(const Ring& ring, std::vector<DirectedEdge>& edges) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges.push_back({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]});
}

/// Takes out the edges between two of the faces, which each of them runs along in its own
/// direction.
void take_out_inner_edges(std::vector<DirectedEdge>& edges) {
  const auto key = [](const DirectedEdge& edge) { return std::minmax(edge.from, edge.to); };
  std::sort(edges.begin(), edges.end(), [&](const DirectedEdge& a, const DirectedEdge& b) {
    return key(a) < key(b) || (key(a) == key(b) && a.from < b.from);
  });
  std::vector<DirectedEdge> kept;
  for (const DirectedEdge& edge : edges) {
    if (!kept.empty() && kept.back().from == edge.to && kept.back().to == edge.from) {
      kept.pop_back();
    } else {
      kept.push_back(edge);
    }
  }
  edges = std::move(kept);
}

/// The faces between lines that are parted where they cross.
struct Faces {
  std::vector<RingFace> faces;
  double area = 0;
  bool closed = true;  ///< whether every piece of a line bounds a face
};

bool is_empty(const Geos& geos, GEOSGeometry* edges) {
  return edges == nullptr || GEOSisEmpty_r(geos.context(), geos.own(edges).get()) == 1;
}

Faces faces_between(const Geos& geos, const GEOSGeometry* lines, double grid) {
  const Geos::Shape noded = geos.own(grid > 0 ? GEOSUnaryUnionPrec_r(geos.context(), lines, grid)
                                              : GEOSUnaryUnion_r(geos.context(), lines));
  require(noded != nullptr, geos);
  GEOSGeometry* cuts = nullptr;
  GEOSGeometry* dangles = nullptr;
  GEOSGeometry* faulty = nullptr;
  const Geos::Shape pieces =
      geos.own(GEOSPolygonize_full_r(geos.context(), noded.get(), &cuts, &dangles, &faulty));
  Faces found;
  for (GEOSGeometry* left : {cuts, dangles, faulty})
    found.closed = is_empty(geos, left) && found.closed;
  require(pieces != nullptr, geos);
  const int count = GEOSGetNumGeometries_r(geos.context(), pieces.get());
  for (int i = 0; i < count; ++i) {
    const GEOSGeometry* piece = GEOSGetGeometryN_r(geos.context(), pieces.get(), i);
    MultiPolygon shape = geos.polygons_of(piece);
    if (shape.size() != 1) continue;
    turn_rings(shape);
    const double area = plane_area(shape);
    found.area += area;
    found.faces.push_back({std::move(shape.front()), area, point_in(geos, piece)});
  }
  return found;
}

/// About the finest grid on which coordinates of this size can be told apart.
double noding_grid(std::span<const Ring> rings) {
  double largest = 0;
  for (const Ring& ring : rings) {
    for (const Point p : ring) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
  }
  return largest > 0 ? std::exp2(std::ilogb(largest) - 46) : 1;
}

}  // namespace

std::vector<RingFace> faces_of(std::span<const Ring> rings, double grid) {
  constexpr double rounding = 1e-12;
  const Geos geos;
  const Geos::Shape lines = geos.lines_of(rings);
  require(lines != nullptr, geos);
  Faces found = faces_between(geos, lines.get(), grid);
  if (grid > 0 || found.closed) return std::move(found.faces);
  // A crossing that is rounded may lie beside a line that ends there. The face behind has a gap in
  // its outline then, and is not found. On a grid lines are parted at every crossing.
  Faces on_grid = faces_between(geos, lines.get(), noding_grid(rings));
  const bool was_lost = on_grid.area > found.area * (1 + rounding);
  return std::move(was_lost ? on_grid.faces : found.faces);
}

MultiPolygon united(std::span<const RingFace* const> faces) {
  std::vector<DirectedEdge> edges;
  for (const RingFace* face : faces) {
    add_edges(face->shape.outer, edges);
    for (const Ring& hole : face->shape.holes) add_edges(hole, edges);
  }
  take_out_inner_edges(edges);
  return link_rings(std::move(edges));
}

}  // namespace thiessen

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/interrupt.h"
#include "geometry/determinants.h"
#include "geometry/space_predicates.h"
#include "geometry/voronoi_measures.h"
#include "tessellation/cell.h"
#include "tessellation/coinciding_vertices.h"
#include "tessellation/edge_ring.h"

namespace thiessen {
namespace {

using Vector = SpaceVector<double>;

/// Finds a cell in space by going round every Delaunay edge at its point. Requires that the points
/// span the space.
class SpaceCellFinder {
 public:
  SpaceCellFinder(const Tessellation<3>& tessellation, PointId p)
      : tessellation_(tessellation),
        topology_(tessellation.topology()),
        star_(star_of(tessellation, p)),
        same_(tessellation, star_, p) {
    cell_.point = p;
  }

  SpaceCell find() && {
    list_vertices();
    list_rays();
    cell_.is_bounded = cell_.rays.empty();
    if (cell_.is_bounded) cell_.volume = 0;
    for (const auto& [q, v] : edges()) add_face(ring_round(topology_, cell_.point, q, v), q);
    cell_.volume /= 12;
    return std::move(cell_);
  }

 private:
  static Star<3> star_of(const Tessellation<3>& tessellation, PointId p) {
    Star<3> star;
    tessellation.find_star(p, star);
    return star;
  }
  const SpacePoint& position(PointId q) const { return tessellation_.position(q); }

  void list_vertices() {
    for (const VertexId v : same_.first()) {
      if (v != no_vertex && !topology_.is_infinite(v))
        cell_.vertices.push_back(voronoi_vertex(tessellation_.structure(), v));
    }
    std::sort(cell_.vertices.begin(), cell_.vertices.end(), [&](const auto& v, const auto& w) {
      throw_if_interrupted();
      if (v.centre != w.centre) return v.centre < w.centre;
      return in_order(tessellation_, v.vertex) < in_order(tessellation_, w.vertex);
    });
    number_.resize(star_.vertices().size());
    for (std::size_t i = 0; i < cell_.vertices.size(); ++i)
      number_[same_.group_of(cell_.vertices[i].vertex)] = i;
  }
  std::size_t number_of(VertexId v) const { return number_[same_.group_of(v)]; }

  void list_rays() {
    for (const VertexId v : same_.first()) {
      if (v != no_vertex && topology_.is_infinite(v))
        cell_.rays.push_back({number_of(same_.inside(v)), outward(v)});
    }
    std::sort(cell_.rays.begin(), cell_.rays.end(), [](const auto& r, const auto& s) {
      return r.from != s.from ? r.from < s.from : r.direction < s.direction;
    });
  }
  SpacePoint outward(VertexId v) const {
    const auto facet = turned_to(topology_, v, infinite_point, cell_.point);
    const Vector normal = unit_normal(position(facet[2]), position(facet[1]), position(facet[3]));
    return {normal.x, normal.y, normal.z};
  }

  // The neighbours in the order of their coordinates, each with one vertex that it forms with p.
  std::vector<std::pair<PointId, VertexId>> edges() const {
    std::vector<std::pair<PointId, VertexId>> edges;
    for (const VertexId v : star_.vertices()) {
      for (const PointId q : topology_.forming(v)) {
        if (q != cell_.point && q != infinite_point) edges.emplace_back(q, v);
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const auto& e, const auto& f) { return e.first == f.first; }),
                edges.end());
    std::sort(edges.begin(), edges.end(),
              [&](const auto& e, const auto& f) { return position(e.first) < position(f.first); });
    return edges;
  }

  void add_face(EdgeRing ring, PointId q) {
    throw_if_interrupted();
    CellFace face;
    face.neighbour = q;
    face.is_bounded = begin_well(ring);
    const std::size_t finite = ring.vertices.size() - (face.is_bounded ? 0 : 2);
    for (std::size_t i = 0; i < finite; ++i) {
      const std::size_t number = number_of(ring.vertices[i]);
      if (face.vertices.empty() || face.vertices.back() != number) face.vertices.push_back(number);
    }
    if (face.is_bounded) {
      if (face.vertices.front() == face.vertices.back()) face.vertices.pop_back();
      if (face.vertices.size() < 3) return;
      const Vector area = doubled_area_of(ring, q);
      face.area = std::hypot(area.x, area.y, area.z) / 2;
      cell_.volume += twelvefold_volume(area, q);
    } else if (face.vertices.size() == 1 &&
               same_.coincide(ring.vertices[finite], ring.vertices[finite + 1])) {
      return;
    }
    cell_.faces.push_back(std::move(face));
  }

  // Rotates the ring so that the infinite point comes last, or where there is none, so that the
  // first point by coordinates comes first. Returns whether there is none, that is, whether the
  // face is bounded.
  bool begin_well(EdgeRing& ring) const {
    auto first = std::find(ring.points.begin(), ring.points.end(), infinite_point);
    const bool is_closed = first == ring.points.end();
    if (is_closed) {
      first = std::min_element(ring.points.begin(), ring.points.end(),
                               [&](PointId r, PointId s) { return position(r) < position(s); });
    } else {
      ++first;
    }
    const auto turn = first - ring.points.begin();
    std::rotate(ring.points.begin(), first, ring.points.end());
    std::rotate(ring.vertices.begin(), ring.vertices.begin() + turn, ring.vertices.end());
    return is_closed;
  }

  // A vector at right angles to the face whose length is twice the face's area. It is the sum over
  // triangles with a corner at the first vertex, which all turn the same way, so that nothing
  // cancels.
  Vector doubled_area_of(const EdgeRing& ring, PointId q) const {
    const std::size_t count = ring.points.size();
    const SpacePoint& p = position(cell_.point);
    Vector reached{0, 0, 0};
    Vector sum{0, 0, 0};
    for (std::size_t i = 1; i < count; ++i) {
      if (same_.coincide(ring.vertices[i - 1], ring.vertices[i])) continue;
      const PointId after = ring.points[i + 1 < count ? i + 1 : 0];
      const Vector edge = voronoi_edge(p, position(q), position(ring.points[i - 1]),
                                       position(ring.points[i]), position(after));
      const Vector triangle = determinant::cross(reached, edge);
      sum = {sum.x + triangle.x, sum.y + triangle.y, sum.z + triangle.z};
      reached = {reached.x + edge.x, reached.y + edge.y, reached.z + edge.z};
    }
    return sum;
  }
  // Twelve times the volume of the pyramid from the point to the face. The face is half-way to q,
  // so the vector to q is twice the pyramid's height.
  double twelvefold_volume(const Vector& doubled_area, PointId q) const {
    const SpacePoint& from = position(cell_.point);
    const SpacePoint& to = position(q);
    return doubled_area.x * (to.x - from.x) + doubled_area.y * (to.y - from.y) +
           doubled_area.z * (to.z - from.z);
  }

  const Tessellation<3>& tessellation_;
  const Topology<3>& topology_;
  Star<3> star_;
  CoincidingVertices same_;
  SpaceCell cell_;
  std::vector<std::size_t> number_;  // by group, its index in the cell's vertices
};

// Finds the neighbours of a cell that is a prism, because the points span less than the space.
// Points that are neighbours only by a tie-break are left out.
SpaceCell prism(const Tessellation<3>& tessellation, PointId p) {
  SpaceCell cell;
  cell.point = p;
  if (tessellation.span() == Span::point) return cell;
  Star<3> star;
  tessellation.find_star(p, star);
  const auto& points = star.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointId before = points[i > 0 ? i - 1 : points.size() - 1];
    const PointId after = points[i + 1 < points.size() ? i + 1 : 0];
    if (points[i] == infinite_point) continue;
    const bool is_edge =
        tessellation.span() == Span::line || before == infinite_point || after == infinite_point ||
        in_circle_in_plane(tessellation.structure().dropped(), tessellation.position(p),
                           tessellation.position(points[i]), tessellation.position(after),
                           tessellation.position(before)) != 0;
    if (is_edge) cell.faces.push_back({points[i], false, {}});
  }
  std::sort(cell.faces.begin(), cell.faces.end(), [&](const CellFace& f, const CellFace& g) {
    return tessellation.position(f.neighbour) < tessellation.position(g.neighbour);
  });
  return cell;
}

}  // namespace

SpaceCell find_cell(const Tessellation<3>& tessellation, PointId p) {
  if (tessellation.span() != Span::space) return prism(tessellation, p);
  return SpaceCellFinder(tessellation, p).find();
}

}  // namespace thiessen

#include "tessellation/deletion.h"

#include "tessellation/at_dimension.h"
#include "tessellation/change_of_dimension.h"

namespace thiessen {

template <int Dimension>
VertexId Deletion<Dimension>::remove(Structure<Dimension>& structure, PointId p) {
  if (structure.topology().dimension() == 0) {
    lower_dimension(structure, p);
    return no_vertex;
  }
  return at_dimension<Dimension>(structure.topology().dimension(),
                                 [&](auto d) { return this->template remove_in<d>(structure, p); });
}

template <int Dimension>
template <int d>
VertexId Deletion<Dimension>::remove_in(Structure<Dimension>& structure, PointId p) {
  Topology<Dimension>& topology = structure.topology();
  // Fetches what the deletion will need round the star while the star's vertices are being found.
  star_.template find<d>(topology, p, [&](PointId q, VertexId beyond) {
    structure.fetch(q);
    topology.fetch(beyond);
  });
  if (is_last_off<d>(structure, p)) {
    lower_dimension(structure, p);
    return topology.vertex_of(infinite_point);
  }
  fill<d>(structure, p);
  topology.release_point(p);
  return new_vertices_.front();
}

// Whether p is the last point off what the others span. That is so only where the facet across from
// p is on the hull in every simplex of p, and all points left lie on the line or plane of one such
// facet.
template <int Dimension>
template <int d>
bool Deletion<Dimension>::is_last_off(const Structure<Dimension>& structure, PointId p) const {
  const Topology<Dimension>& topology = structure.topology();
  bool on_hull = false;
  for (const PointId q : star_.points()) on_hull = on_hull || q == infinite_point;
  if (!on_hull) return false;
  VertexId finite = no_vertex;
  for (const VertexId v : star_.vertices()) {
    if (topology.is_infinite(v)) continue;
    if (!topology.is_infinite(topology.neighbour(v, topology.corner_of(v, p)))) return false;
    finite = v;
  }
  const auto simplex = structure.template simplex<d>(finite);
  const std::size_t corner = topology.corner_of(finite, p);
  for (const PointId q : star_.points()) {
    if (topology.corner_of(finite, q) != Topology<Dimension>::corners || q == infinite_point)
      continue;
    if (structure.template orientation_with<d>(simplex, corner, structure.position(q)) != 0)
      return false;
  }
  return true;
}

template <int Dimension>
template <int d>
void Deletion<Dimension>::fill(Structure<Dimension>& structure, PointId p) {
  const bool many = star_.points().size() > many_points;
  if constexpr (d == 2) {
    if (!many) {
      fill_polygon(structure, p);
      return;
    }
  }
  hole_.template open<d>(structure.topology(), p, star_);
  new_vertices_ = many ? hole_.template fill_from_tessellation<d>(structure)
                       : hole_.template fill<d>(structure);
}

// In the plane the hole is a polygon, which is filled recursively: the triangle at one of its edges
// leaves two smaller polygons.
template <int Dimension>
void Deletion<Dimension>::fill_polygon(Structure<Dimension>& structure, PointId p) {
  Topology<Dimension>& topology = structure.topology();
  rim_.clear();
  for (const VertexId v : star_.vertices()) {
    const VertexId beyond = topology.neighbour(v, topology.corner_of(v, p));
    rim_.push_back({beyond, topology.side_towards(beyond, v)});
  }
  new_vertices_.clear();
  const Side closing = fill_chain(structure, 0, star_.points().size() - 1);
  const Side last = rim_.back();
  topology.fill(closing.vertex).neighbours[closing.side] = last.vertex;
  topology.change(last.vertex).neighbours[last.side] = closing.vertex;
  for (std::size_t i = new_vertices_.size(); i < star_.vertices().size(); ++i) {
    topology.release(star_.vertices()[i]);
  }
}

// Fills the polygon of the star's points from `first` to `last`, closed by the edge between these
// two. Returns the side of the new triangle at the closing edge.
template <int Dimension>
typename Deletion<Dimension>::Side Deletion<Dimension>::fill_chain(Structure<Dimension>& structure,
                                                                   std::size_t first,
                                                                   std::size_t last) {
  if (last == first + 1) return rim_[first];
  Topology<Dimension>& topology = structure.topology();
  const std::size_t apex = apex_of_chain(structure, first, last);
  const VertexId v = star_.vertices()[new_vertices_.size()];
  new_vertices_.push_back(v);
  auto& row = topology.change(v);
  row.forming[0] = star_.points()[last];
  row.forming[1] = star_.points()[first];
  row.forming[2] = star_.points()[apex];
  for (const PointId p : {row.forming[0], row.forming[1], row.forming[2]}) {
    topology.set_vertex_of(p, v);
  }
  const auto join = [&](std::size_t side, const Side& other, bool is_rim) {
    topology.fill(v).neighbours[side] = other.vertex;
    auto& there = is_rim ? topology.change(other.vertex) : topology.fill(other.vertex);
    there.neighbours[other.side] = v;
  };
  join(0, fill_chain(structure, first, apex), apex == first + 1);
  join(1, fill_chain(structure, apex, last), last == apex + 1);
  return {v, 2};
}

// Step 3 of deletion in the plane: finds the point that forms the triangle at the closing edge, the
// one whose circle holds no other point of the polygon.
template <int Dimension>
std::size_t Deletion<Dimension>::apex_of_chain(const Structure<Dimension>& structure,
                                               std::size_t first, std::size_t last) const {
  if (last == first + 2) return first + 1;
  const std::vector<PointId>& points = star_.points();
  typename Structure<Dimension>::template Simplex<2> simplex{points[last], points[first],
                                                             infinite_point};
  const bool finite = points[first] != infinite_point && points[last] != infinite_point;
  std::size_t best = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    if (points[i] == infinite_point) {
      if (best == first) best = i;
      continue;
    }
    const auto& position = structure.position(points[i]);
    if (finite && structure.template orientation_with<2>(simplex, 2, position) <= 0) continue;
    if (best != first && points[best] != infinite_point) {
      simplex[2] = points[best];
      if (!structure.template in_conflict<2>(simplex, position)) continue;
    }
    best = i;
  }
  return best;
}

template class Deletion<2>;
template class Deletion<3>;

}  // namespace thiessen

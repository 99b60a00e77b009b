#include "tessellation/insertion.h"

#include "tessellation/at_dimension.h"

namespace thiessen {
namespace {

// The number of a vertex is below 2^31, so the highest bit is free to mark it.
constexpr std::uint32_t mark = 0x80000000u;

VertexId marked(VertexId v) {
  return VertexId{static_cast<std::uint32_t>(v) | mark};
}
VertexId unmarked(VertexId v) {
  return VertexId{static_cast<std::uint32_t>(v) & ~mark};
}
bool is_marked(VertexId v) {
  return (static_cast<std::uint32_t>(v) & mark) != 0;
}

}  // namespace

template <int Dimension>
VertexId Insertion<Dimension>::insert(Structure<Dimension>& structure, PointId q, VertexId first) {
  return at_dimension<Dimension>(structure.topology().dimension(), [&](auto d) {
    return this->template insert_in<d>(structure, q, first);
  });
}

template <int Dimension>
template <int d>
VertexId Insertion<Dimension>::insert_in(Structure<Dimension>& structure, PointId q,
                                         VertexId first) {
  zone_.template find<d>(structure, first, structure.position(q));  // step 1
  Topology<Dimension>& topology = structure.topology();
  if constexpr (d == 2) {
    fill_ring(topology, q);
  } else {
    fill_star<d>(topology, q);
  }
  topology.set_vertex_of(q, new_vertices_.front());
  return new_vertices_.front();
}

// Steps 2 to 6 of insertion in the plane: there is a new vertex for each facet between a deleted
// vertex and one that is kept. The rim is in order, so each new vertex is linked to the one before
// and the one after. The rows of the deleted vertices, which are two fewer, are used again at once.
template <int Dimension>
void Insertion<Dimension>::fill_ring(Topology<Dimension>& topology, PointId q) {
  const std::vector<Facet>& rim = zone_.rim();
  ring_.clear();
  for (const Facet& f : rim) {
    ring_.push_back(topology.forming(f.inside)[f.side == 2 ? 0 : f.side + 1u]);
  }
  new_vertices_ = zone_.vertices();
  for (const VertexId v : new_vertices_) topology.change(v);
  while (new_vertices_.size() < rim.size()) new_vertices_.push_back(topology.allocate());
  const std::size_t last = rim.size() - 1;
  for (std::size_t k = 0; k <= last; ++k) {
    const VertexId v = new_vertices_[k];
    const std::size_t after = k == last ? 0 : k + 1;
    auto& row = topology.fill(v);
    row.forming[0] = q;
    row.forming[1] = ring_[k];
    row.forming[2] = ring_[after];
    row.neighbours[0] = rim[k].outside;
    row.neighbours[1] = new_vertices_[after];
    row.neighbours[2] = new_vertices_[k == 0 ? last : k - 1];
    topology.change(rim[k].outside).neighbours[rim[k].outside_side] = v;
    topology.set_vertex_of(ring_[k], v);
  }
}

// Steps 2 to 6 of insertion on a line and in space: in each vertex inside the rim, the new point
// takes the place of the forming point across from the rim. The deleted vertices show the way until
// all new ones are linked: across the rim they lead to the new vertex that was made there.
template <int Dimension>
template <int d>
void Insertion<Dimension>::fill_star(Topology<Dimension>& topology, PointId q) {
  new_vertices_.clear();
  for (const VertexId v : zone_.vertices()) topology.change(v);
  for (const Facet& f : zone_.rim()) {
    const VertexId v = topology.allocate();
    new_vertices_.push_back(v);
    auto& row = topology.fill(v);
    row.forming = topology.forming(f.inside);
    row.forming[f.side] = q;
    row.neighbours.fill(no_vertex);
    row.neighbours[f.side] = f.outside;
    topology.change(f.outside).neighbours[f.outside_side] = v;
    topology.fill(f.inside).neighbours[f.side] = marked(v);
    for (std::size_t i = 0; i <= d; ++i) {
      if (i != f.side) topology.set_vertex_of(row.forming[i], v);
    }
  }
  for (std::size_t k = 0; k < new_vertices_.size(); ++k) {
    for (std::size_t i = 0; i <= d; ++i) {
      if (topology.neighbour(new_vertices_[k], i) == no_vertex) link_round_ridge(topology, k, i);
    }
  }
  for (const VertexId v : zone_.vertices()) topology.release(v);
}

// Links the k-th new vertex across its side i. The way to its neighbour starts at the rim, turns
// round the ridge that the side has on the rim through the deleted vertices, and ends at the rim
// again.
template <int Dimension>
void Insertion<Dimension>::link_round_ridge(Topology<Dimension>& topology, std::size_t k,
                                            std::size_t i) {
  VertexId v = zone_.rim()[k].inside;
  std::size_t through = i;
  std::size_t behind = zone_.rim()[k].side;
  for (;;) {
    const VertexId w = topology.neighbour(v, through);
    if (is_marked(w)) {
      topology.fill(new_vertices_[k]).neighbours[i] = unmarked(w);
      topology.fill(unmarked(w)).neighbours[behind] = new_vertices_[k];
      return;
    }
    const PointId left = topology.forming(v)[behind];
    behind = topology.side_towards(w, v);
    through = topology.corner_of(w, left);
    v = w;
  }
}

template class Insertion<2>;
template class Insertion<3>;

}  // namespace thiessen

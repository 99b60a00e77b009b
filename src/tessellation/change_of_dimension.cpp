#include "tessellation/change_of_dimension.h"

#include <utility>
#include <vector>

#include "tessellation/at_dimension.h"

namespace thiessen {
namespace {

/// Reverses the orientation of a simplex by swapping two of its corners.
template <typename Row>
void turn(Row& row) {
  std::swap(row.forming[0], row.forming[1]);
  std::swap(row.neighbours[0], row.neighbours[1]);
}

template <int Dimension>
std::vector<VertexId> vertices_of(const Topology<Dimension>& topology) {
  std::vector<VertexId> vertices;
  topology.for_each_vertex([&](VertexId v) { vertices.push_back(v); });
  return vertices;
}

template <int Dimension>
VertexId allocate(Topology<Dimension>& topology, std::initializer_list<PointId> points) {
  const VertexId v = topology.allocate();
  auto& row = topology.fill(v);
  row.forming.fill(no_point);
  row.neighbours.fill(no_vertex);
  std::copy(points.begin(), points.end(), row.forming.begin());
  for (const PointId p : points) topology.set_vertex_of(p, v);
  return v;
}

template <int Dimension>
void begin(Topology<Dimension>& topology, PointId first) {
  const VertexId v = allocate(topology, {first});
  const VertexId outside = allocate(topology, {infinite_point});
  topology.fill(v).neighbours[0] = outside;
  topology.fill(outside).neighbours[0] = v;
}

// Raises the dimension from a point to a line: a ring of the two points and the infinite one.
template <int Dimension>
void raise_to_line(Structure<Dimension>& structure, PointId second) {
  Topology<Dimension>& topology = structure.topology();
  const VertexId v = structure.finite_vertex();
  PointId a = topology.forming(v)[0];
  PointId b = second;
  if (structure.position(b) < structure.position(a)) std::swap(a, b);
  topology.release(topology.neighbour(v, 0));
  topology.release(v);
  const VertexId ab = allocate(topology, {a, b});
  const VertexId after = allocate(topology, {b, infinite_point});
  const VertexId before = allocate(topology, {infinite_point, a});
  const auto link = [&](VertexId w, VertexId next, VertexId previous) {
    topology.fill(w).neighbours[0] = next;
    topology.fill(w).neighbours[1] = previous;
  };
  link(ab, after, before);
  link(after, before, ab);
  link(before, ab, after);
}

template <int Dimension, int d>
void raise(Structure<Dimension>& structure, PointId apex) {
  Topology<Dimension>& topology = structure.topology();
  const std::vector<VertexId> lower = vertices_of(topology);
  typename Structure<Dimension>::template Simplex<d + 1> simplex;
  const auto& first = topology.forming(structure.finite_vertex());
  std::copy_n(first.begin(), d + 1, simplex.begin());
  simplex.back() = apex;
  if constexpr (d == 1 && Dimension == 3) {
    structure.set_dropped(projection_axis(
        structure.position(simplex[0]), structure.position(simplex[1]), structure.position(apex)));
  }
  const bool turned = structure.template orientation_of<d + 1>(simplex) < 0;

  for (const VertexId v : lower) {
    const bool doubled = !topology.is_infinite(v);
    const VertexId outside = doubled ? topology.allocate() : no_vertex;
    auto& row = topology.change(v);
    row.forming[d + 1] = apex;
    row.neighbours[d + 1] = outside;
  }
  for (const VertexId v : lower) {
    const VertexId outside = topology.neighbour(v, d + 1);
    if (outside == no_vertex) continue;
    auto& row = topology.fill(outside);
    row = topology.row(v);
    row.forming[d + 1] = infinite_point;
    row.neighbours[d + 1] = v;
    for (std::size_t i = 0; i <= d; ++i) {
      const VertexId w = row.neighbours[i];
      if (!topology.is_infinite(w)) row.neighbours[i] = topology.neighbour(w, d + 1);
    }
    if (!turned) turn(row);
  }
  for (const VertexId v : lower) {
    const std::size_t infinite = topology.corner_of(v, infinite_point);
    if (infinite == Topology<Dimension>::corners) continue;
    topology.fill(v).neighbours[d + 1] = topology.neighbour(topology.neighbour(v, infinite), d + 1);
  }
  if (turned) {
    for (const VertexId v : lower) turn(topology.fill(v));
  }
  topology.set_vertex_of(apex, lower.front());
}

/// Removes the corner p from the vertices that p forms, and releases all other vertices. Returns
/// the vertices that are kept.
template <int Dimension, int d>
std::vector<VertexId> drop_corner(Topology<Dimension>& topology, PointId p) {
  std::vector<VertexId> kept;
  for (const VertexId v : vertices_of(topology)) {
    const std::size_t corner = topology.corner_of(v, p);
    if (corner == Topology<Dimension>::corners) {
      topology.release(v);
      continue;
    }
    auto& row = topology.change(v);
    if (corner != d) {
      std::swap(row.forming[corner], row.forming[d]);
      std::swap(row.neighbours[corner], row.neighbours[d]);
      if constexpr (d > 1) turn(row);
    }
    row.forming[d] = no_point;
    row.neighbours[d] = no_vertex;
    kept.push_back(v);
  }
  for (const VertexId v : kept) {
    for (std::size_t i = 0; i < d; ++i) topology.set_vertex_of(topology.forming(v)[i], v);
  }
  return kept;
}

template <int Dimension, int d>
void lower(Structure<Dimension>& structure, PointId p) {
  Topology<Dimension>& topology = structure.topology();
  const std::vector<VertexId> kept = drop_corner<Dimension, d>(topology, p);
  if constexpr (d > 1) {
    const auto simplex = structure.template simplex<d - 1>(structure.finite_vertex());
    if constexpr (d == 3) {
      structure.set_dropped(projection_axis(structure.position(simplex[0]),
                                            structure.position(simplex[1]),
                                            structure.position(simplex[2])));
    }
    if (structure.template orientation_of<d - 1>(simplex) < 0) {
      for (const VertexId v : kept) turn(topology.fill(v));
    }
  }
}

}  // namespace

template <int Dimension>
void raise_dimension(Structure<Dimension>& structure, PointId apex) {
  Topology<Dimension>& topology = structure.topology();
  const int dimension = topology.dimension();
  if (dimension < 0) {
    begin(topology, apex);
  } else if (dimension == 0) {
    raise_to_line(structure, apex);
  } else if (dimension == 1) {
    raise<Dimension, 1>(structure, apex);
  } else if constexpr (Dimension == 3) {
    raise<Dimension, 2>(structure, apex);
  }
  topology.set_dimension(dimension + 1);
}

template <int Dimension>
void lower_dimension(Structure<Dimension>& structure, PointId p) {
  Topology<Dimension>& topology = structure.topology();
  const int dimension = topology.dimension();
  if (dimension == 0) {
    topology.release(topology.vertex_of(p));
    topology.release(topology.vertex_of(infinite_point));
  } else {
    at_dimension<Dimension>(dimension, [&](auto d) { lower<Dimension, d>(structure, p); });
  }
  topology.set_dimension(dimension - 1);
  topology.release_point(p);
}

template void raise_dimension(Structure<2>&, PointId);
template void raise_dimension(Structure<3>&, PointId);
template void lower_dimension(Structure<2>&, PointId);
template void lower_dimension(Structure<3>&, PointId);

}  // namespace thiessen

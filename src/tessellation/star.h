#pragma once

#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/topology.h"

namespace thiessen {

/// Goes counter-clockwise round a point of the plane, and calls `meet(v, next, beyond)` for every
/// vertex v that it forms: `next` is the point that follows it in v's simplex, and `beyond` is the
/// vertex across from it. Requires that the points span two dimensions.
template <int Dimension, typename Meet>
void walk_round(const Topology<Dimension>& topology, PointId p, Meet&& meet) {
  const VertexId first = topology.vertex_of(p);
  VertexId v = first;
  do {
    const auto& row = topology.row(v);
    const std::size_t next = row.forming[0] == p ? 1 : row.forming[1] == p ? 2 : 0;
    const VertexId after = row.neighbours[next];
    meet(v, row.forming[next], row.neighbours[next == 0 ? 2 : next - 1]);
    v = after;
  } while (v != first);
}

/// The vertices that a point forms, and the points that form them with it. In the plane both are in
/// counter-clockwise order round the point: points()[i] and points()[i + 1] form vertices()[i] with
/// it. For a point that is to be deleted they are the thesis' LISTOFV and LISTOFP (section 2.3,
/// step 1). Cost: in proportion to the vertices.
template <int Dimension>
class Star {
 public:
  const std::vector<VertexId>& vertices() const { return vertices_; }
  /// The points that form the vertices with it. The infinite point is among them where the point is
  /// on the hull.
  const std::vector<PointId>& points() const { return points_; }

  /// Finds the star of p. For every vertex it calls `meet(neighbour, beyond)` on the way, with one
  /// of the vertex's other points and the vertex across from p, so that the caller can fetch them
  /// early. Requires d = the topology's dimension, at least 1, and that p is there.
  template <int d, typename Meet>
  void find(const Topology<Dimension>& topology, PointId p, Meet&& meet) {
    vertices_.clear();
    points_.clear();
    if constexpr (d == 2) {
      walk_round(topology, p, [&](VertexId v, PointId next, VertexId beyond) {
        meet(next, beyond);
        vertices_.push_back(v);
        points_.push_back(next);
      });
    } else {
      search<d>(topology, p, meet);
    }
  }
  template <int d>
  void find(const Topology<Dimension>& topology, PointId p) {
    find<d>(topology, p, [](PointId, VertexId) {});
  }

 private:
  template <int d, typename Meet>
  void search(const Topology<Dimension>& topology, PointId p, Meet& meet) {
    seen_.clear();
    seen_points_.clear();
    const auto open = [&](VertexId v) {
      if (seen_.insert({static_cast<std::uint32_t>(v)}, 0).second) vertices_.push_back(v);
    };
    open(topology.vertex_of(p));
    for (std::size_t next = 0; next < vertices_.size(); ++next) {
      const auto& row = topology.row(vertices_[next]);
      for (std::size_t i = 0; i <= d; ++i) {
        if (row.forming[i] == p) {
          meet(row.forming[i == 0 ? 1 : 0], row.neighbours[i]);
          continue;
        }
        open(row.neighbours[i]);
        if (seen_points_.insert({static_cast<std::uint32_t>(row.forming[i])}, 0).second) {
          points_.push_back(row.forming[i]);
        }
      }
    }
  }

  std::vector<VertexId> vertices_;
  std::vector<PointId> points_;
  IdTable<1> seen_;
  IdTable<1> seen_points_;
};

}  // namespace thiessen

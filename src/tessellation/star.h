#pragma once

#include <vector>

#include "tessellation/id_table.h"
#include "tessellation/topology.h"

namespace thiessen {

/// The vertices that a point forms, and the points that form them with it. In the plane both are in
/// order round the point, counter-clockwise: points()[i] and points()[i + 1] form vertices()[i]
/// with it. On a line and in a plane every vertex is met once from its neighbour; in space there is
/// a table of those seen. Cost: the vertices'.
template <int Dimension>
class Star {
 public:
  const std::vector<VertexId>& vertices() const { return vertices_; }
  /// The infinite point among them, where the point is on the hull.
  const std::vector<PointId>& points() const { return points_; }

  /// Requires d = the topology's dimension, at least 1, and a point that is there.
  template <int d>
  void find(const Topology<Dimension>& topology, PointId p) {
    vertices_.clear();
    points_.clear();
    if constexpr (d == 2) {
      walk_round(topology, p);
    } else {
      search<d>(topology, p);
    }
  }

 private:
  void walk_round(const Topology<Dimension>& topology, PointId p) {
    const VertexId first = topology.vertex_of(p);
    VertexId v = first;
    do {
      const auto& row = topology.row(v);
      const std::size_t next = row.forming[0] == p ? 1 : row.forming[1] == p ? 2 : 0;
      vertices_.push_back(v);
      points_.push_back(row.forming[next]);
      v = row.neighbours[next];
    } while (v != first);
  }

  template <int d>
  void search(const Topology<Dimension>& topology, PointId p) {
    seen_.clear();
    seen_points_.clear();
    const auto open = [&](VertexId v) {
      if (seen_.insert({static_cast<std::uint32_t>(v)}, 0).second) vertices_.push_back(v);
    };
    open(topology.vertex_of(p));
    for (std::size_t next = 0; next < vertices_.size(); ++next) {
      const auto& row = topology.row(vertices_[next]);
      for (std::size_t i = 0; i <= d; ++i) {
        if (row.forming[i] == p) continue;
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

#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/disjoint_sets.h"
#include "geometry/point.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The circumcentres of a tessellation's simplices. Cocircular simplices have one centre. So have
/// neighbouring simplices whose centres rounding cannot tell apart, because an edge so short could
/// point in any direction. A group of such simplices is known by the number of one of them.
class PlaneCentres {
 public:
  /// Requires points that span the plane. The tessellation must outlive this object, and not
  /// change. Cost: linear.
  explicit PlaneCentres(const Tessellation<2>& tessellation);

  std::uint32_t group_of(VertexId v) { return groups_.find(index(v)); }
  Point of(VertexId v) const { return centre_[index(v)]; }

 private:
  template <typename AreOne>
  bool unite(AreOne&& are_one);
  void compute();
  bool are_cocircular(VertexId v, VertexId w) const;
  double rounding(VertexId v) const;
  Point centre_of(VertexId v) const;
  std::array<Point, 3> corners_of(VertexId v) const;
  Point position(PointId p) const { return tessellation_.position(p); }

  const Tessellation<2>& tessellation_;
  const Topology<2>& topology_;
  DisjointSets groups_;
  std::vector<Point> centre_;
};

}  // namespace thiessen

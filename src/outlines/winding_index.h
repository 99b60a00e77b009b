#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "geometry/box_tree.h"
#include "geometry/polygon.h"

namespace thiessen {

/// How often each of many rings winds round a point, counter-clockwise. Rings may cross each other
/// and themselves, and run along each other. Cost: n log n in the vertices to build; for a point
/// log n and the edges on its way to the west.
class WindingIndex {
 public:
  explicit WindingIndex(std::span<const Ring> rings);

  /// The winding numbers of the rings that wind round `p` at all, by the ring's number. Each is
  /// exact for a point on no ring; on a ring it is that of one of the ring's two sides.
  std::map<std::uint32_t, int> at(Point p) const;

 private:
  struct Edge {
    Point from;
    Point to;
    std::uint32_t ring;
  };
  static std::vector<Edge> edges_of(std::span<const Ring> rings);
  static BoxTree tree_of(std::span<const Edge> edges);

  std::vector<Edge> edges_;
  BoxTree tree_;
  double west_ = 0;
};

}  // namespace thiessen

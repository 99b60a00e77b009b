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
/// log n, and the edges to its west of the rings in whose boxes it lies.
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
  };
  /// The edges of one ring, found by their boxes: of thousands of rings side by side only those
  /// round a point are looked at.
  class RingEdges {
   public:
    explicit RingEdges(const Ring& ring);
    const Box& box() const { return box_; }
    int winding_number(Point p) const;

   private:
    static std::vector<Edge> edges_of(const Ring& ring);
    static BoxTree tree_of(std::span<const Edge> edges);

    std::vector<Edge> edges_;
    BoxTree tree_;
    Box box_;
  };
  static BoxTree tree_of(std::span<const RingEdges> rings);

  std::vector<RingEdges> rings_;
  BoxTree tree_;
};

}  // namespace thiessen

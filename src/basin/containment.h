#pragma once

#include <span>
#include <vector>

#include "basin/basin.h"
#include "geometry/box_tree.h"

namespace thiessen {

/// Tells whether points lie in a basin, or on its edge, exactly. Building: n log n in the vertices;
/// a point: log n, and the edges on its way to the basin's western side.
class Containment {
 public:
  explicit Containment(const Basin& basin);
  bool contains(Point p) const;

 private:
  struct Edge {
    Point from;
    Point to;
  };
  std::vector<Edge> edges_;
  BoxTree tree_;
  double west_;
};

/// Which of the points each basin contains, in rising order; with `period` above 0, x repeats after
/// it. Cost: n log n in stations, basins and vertices, and as Containment for each point in a
/// basin's box.
std::vector<std::vector<std::size_t>> points_within(const std::vector<Basin>& basins,
                                                    std::span<const Point> points, double period);
/// How many of them.
std::vector<std::size_t> count_within(const std::vector<Basin>& basins,
                                      std::span<const Point> points, double period);

}  // namespace thiessen

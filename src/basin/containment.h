#pragma once

#include <span>
#include <vector>

#include "basin/basin.h"
#include "geometry/box_tree.h"

namespace thiessen {

/// Tells exactly whether points lie in a basin or on its edge. Cost: n log n in the vertices to
/// build; for a point log n and the edges on its way to the basin's western side.
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

/// The points that each basin contains, by basin, as positions in rising order. Where `period` is
/// above 0, x repeats after it. Cost: n log n in stations, basins and vertices, and a test by
/// Containment for each point in a basin's box.
std::vector<std::vector<std::size_t>> points_within(const std::vector<Basin>& basins,
                                                    std::span<const Point> points, double period);
/// The number of points that each basin contains, by basin; see points_within.
std::vector<std::size_t> count_within(const std::vector<Basin>& basins,
                                      std::span<const Point> points, double period);

}  // namespace thiessen

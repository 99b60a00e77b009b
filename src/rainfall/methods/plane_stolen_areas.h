#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rainfall/methods/stolen_area.h"

namespace thiessen {

/// What a point of the plane would take from the cells of gauges.
///
/// What it takes from the gauge p is bounded by edges of Voronoi cells: the new one between the
/// two, and parts of those between p and other gauges q. Such an edge, whose Delaunay edge p -> q
/// has r to its left and s to its right, is (cot r + cot s) |pq| / 2 long and (|xq|^2 - |xp|^2) /
/// 2|pq| from the point x, and so adds (cot r + cot s) (|xq|^2 - |xp|^2) / 8 to the area of p and
/// takes it from that of q. Each of these triangles lies in the new cell of x, and the cotangents'
/// sum is one fraction of determinants (see edge_ratio); so nothing cancels out that is not a part
/// of the new cell's area, however far away centres are.
class PlaneStolenAreas {
 public:
  /// From each gauge on the zone's rim, in its order. Requires the zone of x, without the infinite
  /// point. Accuracy: 2e-13 of all that is taken: terms are computed in doubles with a bound on the
  /// error, and by exact determinants where that is too large. Cost: 0.3 microseconds for a zone of
  /// four vertices, and as much for an exact term.
  void find(const Structure<2>& structure, const ConflictZone<2>& zone, Point x,
            std::vector<StolenArea>& areas);

 private:
  /// A gauge of the rim as seen from x, and the triangle of x, it and the next.
  struct Corner {
    Point position;
    Point from_x;
    double square;
    double doubled_area;
  };

  void see_corners(const Structure<2>& structure, const ConflictZone<2>& zone, Point x);
  void mark_vertices(const Structure<2>& structure, const ConflictZone<2>& zone);
  double add_all(const Structure<2>& structure, const ConflictZone<2>& zone, Point x, double limit);
  double add_inner(const Structure<2>& structure, const ConflictZone<2>& zone, Point x,
                   double limit);
  const Corner& corner(PointId p) const { return corners_[local_[index(p)]]; }

  std::vector<Corner> corners_;
  std::vector<double> sums_;          // by corner, eight times the area
  std::vector<std::uint32_t> local_;  // by point, its corner
  std::vector<double> doubled_area_;  // by vertex of the zone
  std::vector<std::uint32_t> mark_;   // by vertex, the zone it is in
  std::uint32_t zone_number_ = 0;
};

}  // namespace thiessen

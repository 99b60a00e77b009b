#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "rainfall/methods/stolen_area.h"

namespace thiessen {

/// The areas that a point x of the plane, if it were a gauge, would take from the cells of gauges.
///
/// What x takes from the gauge p is bounded by edges of Voronoi cells: the new edge between x and
/// p, and parts of the old edges between p and other gauges q. Let the Delaunay edge p -> q of such
/// an old edge have r to its left and s to its right. Then the Voronoi edge is (cot r + cot s) |pq|
/// / 2 long and (|xq|^2 - |xp|^2) / 2|pq| from x. So the triangle of x and the edge adds (cot r +
/// cot s) (|xq|^2 - |xp|^2) / 8 to the area of p and takes it from that of q. Each of these
/// triangles lies in the new cell of x, and the sum of the cotangents is one fraction of
/// determinants (see edge_ratio). So only parts of the new cell's area cancel, however far away the
/// centres of circles are.
class PlaneStolenAreas {
 public:
  /// Finds the area taken from each gauge on the zone's rim, in the order of the rim. Requires the
  /// conflict zone of x, without the infinite point. Accuracy: 2e-13 of all that is taken. Terms
  /// are computed in doubles with a bound on the error, and by exact determinants where that bound
  /// is too large. Cost: 0.3 microseconds for a zone of four vertices, and as much for each exact
  /// term.
  void find(const Structure<2>& structure, const ConflictZone<2>& zone, Point x,
            std::vector<StolenArea>& areas);

 private:
  /// A gauge of the rim as seen from x. The doubled area is that of the triangle of x, this gauge
  /// and the next.
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
  std::vector<double> sums_;          // by corner: eight times the area taken
  std::vector<std::uint32_t> local_;  // by point: its corner
  std::vector<double> doubled_area_;  // by vertex of the zone
  std::vector<std::uint32_t> mark_;   // by vertex: the number of the zone it is in
  std::uint32_t zone_number_ = 0;
};

}  // namespace thiessen

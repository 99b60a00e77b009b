#include "diagram/plane_dual.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/interrupt.h"
#include "diagram/plane_centres.h"
#include "diagram/plane_sides.h"
#include "geometry/voronoi_measures.h"
#include "tessellation/tessellation.h"

namespace thiessen {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

class PlaneDual {
 public:
  explicit PlaneDual(std::span<const Point> places) {
    const std::vector<PointId> points = tessellation_.add_all(places);
    place_of_.resize(topology().point_limit());
    for (std::uint32_t i = 0; i < places.size(); ++i) place_of_[index(points[i])] = PlaceIndex{i};
  }

  Dual find() && {
    if (tessellation_.span() == Span::line) add_parallel_borders();
    if (tessellation_.span() == Span::plane) {
      add_triangles();
      add_borders();
    }
    put_in_order(dual_);
    return std::move(dual_);
  }

 private:
  const Topology<2>& topology() const { return tessellation_.topology(); }
  Point position(PointId p) const { return tessellation_.position(p); }
  PlaceIndex place_of(PointId p) const { return place_of_[index(p)]; }

  void add_parallel_borders() {
    const std::vector<PointId> line = tessellation_.along_line();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) add_border(line[i], line[i + 1], infinity);
  }

  void add_triangles() {
    topology().for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      if (topology().is_infinite(v)) return;
      const auto& forming = topology().forming(v);
      dual_.triangles.push_back({place_of(forming[0]), place_of(forming[1]), place_of(forming[2])});
    });
  }

  void add_borders() {
    PlaneCentres centres(tessellation_);
    for_each_joined_pair(topology(), [&](PointId a, PointId b, VertexId v, std::size_t side) {
      throw_if_interrupted();
      const VertexId w = topology().neighbour(v, side);
      if (topology().is_infinite(v) || topology().is_infinite(w)) {
        add_border(a, b, infinity);
      } else if (centres.group_of(v) != centres.group_of(w)) {
        const PointId across = topology().forming(w)[topology().side_towards(w, v)];
        add_border(a, b,
                   length(position(a), position(b), position(topology().forming(v)[side]),
                          position(across)));
      }
    });
  }

  // The length of the border between p and q, with r to the left of p -> q and s to its right. It
  // is computed in one direction only, so that rounding is the same for any order of places.
  static double length(Point p, Point q, Point r, Point s) {
    if (q < p) return length(q, p, s, r);
    return edge_ratio(p, q, r, s) * (std::hypot(q.x - p.x, q.y - p.y) / 2);
  }

  void add_border(PointId a, PointId b, double length) {
    dual_.borders.push_back({place_of(a), place_of(b), length});
  }

  Tessellation<2> tessellation_;
  std::vector<PlaceIndex> place_of_;
  Dual dual_;
};

}  // namespace

Dual plane_dual(std::span<const Point> places) {
  return PlaneDual(places).find();
}

}  // namespace thiessen

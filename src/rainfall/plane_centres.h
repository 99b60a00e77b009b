#pragma once

#include <utility>
#include <vector>

#include "geometry/predicates.h"
#include "tessellation/structure.h"

namespace thiessen {

/// The centre of the circle through o, p, q, from o on. Accuracy: 1e-14 of its length, however thin
/// the triangle. Requires that they are not on one line.
inline Point centre_from(Point o, Point p, Point q) {
  Point u{p.x - o.x, p.y - o.y};
  Point v{q.x - o.x, q.y - o.y};
  Point e{q.x - p.x, q.y - p.y};
  double twice_area = doubled_area(o, p, q);
  double u_square = u.x * u.x + u.y * u.y;
  if (v.x * v.x + v.y * v.y < u_square) {  // so that what follows does not cancel out
    std::swap(u, v);
    e = {-e.x, -e.y};
    twice_area = -twice_area;
    u_square = u.x * u.x + u.y * u.y;
  }
  const double difference = e.x * (u.x + v.x) + e.y * (u.y + v.y);
  return {(u_square * e.y - difference * u.y) / (2 * twice_area),
          (difference * u.x - u_square * e.x) / (2 * twice_area)};
}

/// The vertices of a tessellation of the plane as they are seen from a point, for
/// find_stolen_areas.
class PlaneCentres {
 public:
  /// Takes the vertices as they are now. Cost: theirs.
  void take(const Structure<2>& structure) {
    offsets_.resize(structure.topology().size());
    structure.topology().for_each_vertex([&](VertexId v) {
      if (structure.topology().is_infinite(v)) return;
      const auto& forming = structure.topology().forming(v);
      offsets_[index(v)] =
          centre_from(structure.position(forming[0]), structure.position(forming[1]),
                      structure.position(forming[2]));
    });
  }

  /// As seen from a point.
  class Seen {
   public:
    using Centre = Point;
    Seen(const PlaneCentres& all, const Structure<2>& structure, Point from)
        : all_(all), structure_(structure), from_(from) {}

    Point old(VertexId v) const {
      const Point origin = structure_.position(structure_.topology().forming(v)[0]);
      const Point offset = all_.offsets_[index(v)];
      return {offset.x + (origin.x - from_.x), offset.y + (origin.y - from_.y)};
    }
    Point fresh(PointId p, PointId q) const {
      return centre_from(from_, structure_.position(p), structure_.position(q));
    }
    static double area(Point a, Point b, Point c) {
      return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }

   private:
    const PlaneCentres& all_;
    const Structure<2>& structure_;
    Point from_;
  };

 private:
  std::vector<Point> offsets_;  // by vertex, from its first forming point
};

}  // namespace thiessen

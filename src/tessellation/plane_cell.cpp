#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geometry/predicates.h"
#include "geometry/voronoi_measures.h"
#include "tessellation/cell.h"

namespace thiessen {
namespace {

/// Finds a cell of the plane by going round its point once.
class PlaneCellFinder {
 public:
  PlaneCellFinder(const Tessellation<2>& tessellation, PointId p) : tessellation_(tessellation) {
    cell_.point = p;
  }

  PlaneCell find() && {
    if (tessellation_.span() == Span::plane) {
      look_round();
      add_edges();
      if (cell_.is_bounded) {
        begin_at_first();
      } else {
        add_rays();
      }
    } else if (tessellation_.span() == Span::line) {
      tessellation_.for_each_neighbour(cell_.point,
                                       [&](PointId q) { cell_.neighbours.push_back(q); });
      std::sort(cell_.neighbours.begin(), cell_.neighbours.end(),
                [&](PointId q, PointId r) { return position(q) < position(r); });
    }
    return std::move(cell_);
  }

 private:
  const Point& position(PointId q) const { return tessellation_.position(q); }
  PointId after(std::size_t i) const { return points_[i + 1 < points_.size() ? i + 1 : 0]; }
  PointId before(std::size_t i) const { return points_[i > 0 ? i - 1 : points_.size() - 1]; }

  // Finds the point's neighbours in order. The infinite point comes last where there is one;
  // otherwise the round begins with the edge to the first neighbour by coordinates.
  void look_round() {
    Star<2> star;
    tessellation_.find_star(cell_.point, star);
    points_ = star.points();
    vertices_ = star.vertices();
    const auto infinite = std::find(points_.begin(), points_.end(), infinite_point);
    cell_.is_bounded = infinite == points_.end();
    std::size_t first = static_cast<std::size_t>(infinite - points_.begin()) + 1;
    if (cell_.is_bounded) first = first_edge();
    first %= points_.size();
    const auto turn = [first](auto& ring) {
      std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(first), ring.end());
    };
    turn(points_);
    turn(vertices_);
  }

  std::size_t first_edge() const {
    std::size_t first = points_.size();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!is_edge(i)) continue;
      if (first == points_.size() || position(points_[i]) < position(points_[first])) first = i;
    }
    return first;
  }
  bool is_edge(std::size_t i) const {
    if (before(i) == infinite_point || after(i) == infinite_point) return true;
    return in_circle(position(cell_.point), position(points_[i]), position(after(i)),
                     position(before(i))) != 0;
  }

  void add_edges() {
    double area = 0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (points_[i] == infinite_point) continue;
      if (is_edge(i)) {
        cell_.neighbours.push_back(points_[i]);
        if (after(i) != infinite_point) cell_.vertices.push_back(vertex(vertices_[i]));
        if (cell_.is_bounded)
          area += sector_area(position(cell_.point), position(points_[i]), position(after(i)),
                              position(before(i)));
      } else if (comes_first(vertices_[i], cell_.vertices.back().vertex)) {
        cell_.vertices.back() = vertex(vertices_[i]);
      }
    }
    if (cell_.is_bounded) cell_.area = area;
  }

  VoronoiVertex<2> vertex(VertexId v) const { return voronoi_vertex(tessellation_.structure(), v); }
  bool comes_first(VertexId v, VertexId w) const { return forming(v) < forming(w); }
  std::array<Point, 3> forming(VertexId v) const {
    const auto& points = tessellation_.topology().forming(v);
    std::array<Point, 3> positions{position(points[0]), position(points[1]), position(points[2])};
    std::sort(positions.begin(), positions.end());
    return positions;
  }

  void add_rays() {
    const Point& p = position(cell_.point);
    const Point& next = position(cell_.neighbours.front());
    const Point& previous = position(cell_.neighbours.back());
    cell_.rays = {{0, outward(p, next)}, {cell_.vertices.size() - 1, outward(previous, p)}};
  }
  // The direction of length 1 at right angles to an edge of the hull, away from the points, which
  // are to the edge's left.
  static Point outward(Point from, Point to) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    return {(to.y - from.y) / length, (from.x - to.x) / length};
  }

  void begin_at_first() {
    const auto first =
        std::min_element(cell_.vertices.begin(), cell_.vertices.end(),
                         [](const auto& v, const auto& w) { return v.centre < w.centre; });
    const auto turn = first - cell_.vertices.begin();
    std::rotate(cell_.neighbours.begin(), cell_.neighbours.begin() + turn, cell_.neighbours.end());
    std::rotate(cell_.vertices.begin(), first, cell_.vertices.end());
  }

  const Tessellation<2>& tessellation_;
  PlaneCell cell_;
  std::vector<PointId> points_;  // in order round the point; points i and i + 1 form vertices_[i]
  std::vector<VertexId> vertices_;
};

}  // namespace

PlaneCell find_cell(const Tessellation<2>& tessellation, PointId p) {
  return PlaneCellFinder(tessellation, p).find();
}

}  // namespace thiessen

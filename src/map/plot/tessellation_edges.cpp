#include "map/plot/tessellation_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "base/interrupt.h"
#include "geometry/predicates.h"
#include "geometry/space_predicates.h"
#include "map/plot/box_cut.h"
#include "map/plot/scene_vector.h"

namespace thiessen {
namespace {

template <std::size_t Corners>
using Points = std::array<PointId, Corners>;

/// Finds what the tessellations of every span have in common: Delaunay edges, and Voronoi vertices
/// by number.
template <int Dimension>
class EdgeFinder {
 public:
  using Coordinates = CoordinatesIn<Dimension>;
  using Position = PositionIn<Dimension>;

  EdgeFinder(const Tessellation<Dimension>& tessellation, const SceneCoordinates<Dimension>& scene,
             const Coordinates& half)
      : tessellation_(tessellation), scene_(scene), half_(half) {}

  void find_delaunay_edges() {
    Star<Dimension> star;
    tessellation_.for_each_point([&](PointId p) {
      throw_if_interrupted();
      tessellation_.for_each_neighbour(p, star, [&](PointId q) {
        if (position(p) < position(q)) edges.delaunay.push_back({place(p), place(q)});
      });
    });
  }

  TessellationEdges<Dimension> edges;

 protected:
  const Topology<Dimension>& topology() const { return tessellation_.topology(); }
  const Position& position(PointId p) const { return tessellation_.position(p); }
  Position shifted(PointId p) const { return scene_.shifted(position(p)); }
  Coordinates place(PointId p) const { return scene_(position(p)); }

  /// Computes the place of every finite vertex. Requires a span of d dimensions.
  template <int d, typename Centre>
  void place_vertices(Centre&& centre) {
    vertices_.resize(topology().size());
    topology().for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      if (!topology().is_infinite(v)) vertices_[index(v)] = centre(topology().forming(v));
    });
  }

  /// Calls `visit(facet, v, w)` for each facet without the infinite point that lies between two
  /// vertices, of which v is finite. The facet's points are in lexicographic order. Requires a span
  /// of d dimensions, d >= 2.
  template <int d, typename Visit>
  void for_each_facet(Visit&& visit) const {
    topology().for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      for (std::size_t i = 0; i <= d; ++i) {
        const VertexId w = topology().neighbour(v, i);
        if (w < v) continue;
        Points<std::size_t{d}> facet;
        for (std::size_t k = 0; k < d; ++k) facet[k] = topology().forming(v)[(i + k + 1) % (d + 1)];
        if (std::find(facet.begin(), facet.end(), infinite_point) != facet.end()) continue;
        std::sort(facet.begin(), facet.end(),
                  [this](PointId a, PointId b) { return position(a) < position(b); });
        if (topology().is_infinite(v)) {
          visit(facet, w, v);
        } else {
          visit(facet, v, w);
        }
      }
    });
  }

  /// The forming point of v that w does not have.
  PointId apex(VertexId v, VertexId w) const {
    return topology().forming(v)[topology().side_towards(v, w)];
  }

  /// The stretch of the line from v to w, or without end where w is infinite. `side` is 1 where the
  /// line's direction leads from the facet between them towards v's apex, and -1 where it leads
  /// away from it.
  Stretch stretch(const Line<Dimension>& line, VertexId v, VertexId w, int side) const {
    const double at_v = parameter(line, vertices_[index(v)]);
    if (topology().is_infinite(w)) return side > 0 ? Stretch{.to = at_v} : Stretch{.from = at_v};
    const double at_w = parameter(line, vertices_[index(w)]);
    return {std::min(at_v, at_w), std::max(at_v, at_w)};
  }

  /// Adds the part of the edge that lies in the box. An end inside is the vertex itself, so that
  /// edges meet.
  void add_voronoi_edge(const Line<Dimension>& line, VertexId v, VertexId w, int side) {
    const auto seen = cut_to_box<Dimension>(line, stretch(line, v, w, side), half_);
    if (!seen) return;
    EdgeIn<Dimension> edge{line.at(seen->from), line.at(seen->to)};
    const bool forward = !topology().is_infinite(w) ? parameter(line, vertices_[index(v)]) <=
                                                          parameter(line, vertices_[index(w)])
                                                    : side < 0;
    take_vertex(v, forward ? edge.from : edge.to);
    take_vertex(w, forward ? edge.to : edge.from);
    edges.voronoi.push_back(edge);
  }

  void add_whole_line(const Line<Dimension>& line) {
    if (const auto seen = cut_to_box<Dimension>(line, {}, half_)) {
      edges.voronoi.push_back({line.at(seen->from), line.at(seen->to)});
    }
  }

  const Tessellation<Dimension>& tessellation_;
  const SceneCoordinates<Dimension>& scene_;
  const Coordinates half_;
  std::vector<Coordinates> vertices_;

 private:
  static double parameter(const Line<Dimension>& line, const Coordinates& place) {
    double along = 0;
    double square = 0;
    for (std::size_t i = 0; i < place.size(); ++i) {
      along += (place[i] - line.anchor[i]) * line.direction[i];
      square += line.direction[i] * line.direction[i];
    }
    return along / square;
  }

  void take_vertex(VertexId v, Coordinates& end) const {
    if (topology().is_infinite(v)) return;
    if (is_in_box<Dimension>(vertices_[index(v)], half_)) end = vertices_[index(v)];
  }
};

class PlaneEdgeFinder : public EdgeFinder<2> {
 public:
  using EdgeFinder::EdgeFinder;

  void find() {
    if (tessellation_.span() == Span::line) find_parallel_edges();
    if (tessellation_.span() == Span::plane) find_edges_between_vertices();
  }

 private:
  /// The line through the middle of a and b, square to a→b; its direction leads to the left of a→b.
  Line<2> bisector(PointId a, PointId b) const {
    const Point p = shifted(a);
    const Point q = shifted(b);
    const CoordinatesIn<2> across{(p.y - q.y) * scene_.scale(0), (q.x - p.x) * scene_.scale(1)};
    const double length = std::hypot(across[0], across[1]);
    return {scene_.placed({p.x / 2 + q.x / 2, p.y / 2 + q.y / 2}),
            {across[0] / length, across[1] / length}};
  }

  void find_parallel_edges() {
    const std::vector<PointId> line = tessellation_.along_line();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      add_whole_line(bisector(line[i], line[i + 1]));
    }
  }

  void find_edges_between_vertices() {
    place_vertices<2>([this](const auto& f) {
      return scene_.placed(circumcentre(shifted(f[0]), shifted(f[1]), shifted(f[2])));
    });
    for_each_facet<2>([this](const Points<2>& facet, VertexId v, VertexId w) {
      if (!topology().is_infinite(w) && are_one(v, w)) return;
      const auto [a, b] = facet;
      const int side = orientation(position(a), position(b), position(apex(v, w)));
      add_voronoi_edge(bisector(a, b), v, w, side);
    });
  }

  bool are_one(VertexId v, VertexId w) const {
    const auto& f = topology().forming(v);
    return in_circle(position(f[0]), position(f[1]), position(f[2]), position(apex(w, v))) == 0;
  }
};

class SpaceEdgeFinder : public EdgeFinder<3> {
 public:
  SpaceEdgeFinder(const Tessellation<3>& tessellation, const SceneCoordinates<3>& scene,
                  const SceneVector& half)
      : EdgeFinder(tessellation, scene, half), far_(4 * length(half)) {}

  void find() {
    if (tessellation_.span() == Span::line) find_parallel_walls();
    if (tessellation_.span() == Span::plane) find_walls_between_lines();
    if (tessellation_.span() == Span::space) find_edges_between_vertices();
  }

 private:
  /// The step from one point to another, in units of the scene. It is computed from unshifted
  /// positions, and so keeps their full accuracy.
  SceneVector step(PointId from, PointId to) const {
    const SpacePoint& p = position(from);
    const SpacePoint& q = position(to);
    return scene_.scale(0) * SceneVector{q.x - p.x, q.y - p.y, q.z - p.z};
  }

  /// The cross product of a→b and a→c, equally accurate however thin the triangle is.
  SceneVector normal(PointId a, PointId b, PointId c) const {
    const auto area = [&](Axis dropped) {
      const double doubled =
          doubled_area(projected(dropped, position(a)), projected(dropped, position(b)),
                       projected(dropped, position(c)));
      return doubled * scene_.scale(0) * scene_.scale(0);
    };
    return {area(Axis::x), area(Axis::y), area(Axis::z)};
  }

  /// The line of all places equally far from the three points; its direction leads to the side from
  /// which they are seen counter-clockwise.
  Line<3> axis(PointId a, PointId b, PointId c) const {
    const SceneVector u = step(a, b);
    const SceneVector v = step(a, c);
    const SceneVector n = normal(a, b, c);
    const SceneVector towards = dot(u, u) * cross(v, n) + dot(v, v) * cross(n, u);
    return {place(a) + (0.5 / dot(n, n)) * towards, unit(n)};
  }

  void find_edges_between_vertices() {
    place_vertices<3>([this](const auto& f) {
      return scene_.placed(
          circumcentre(shifted(f[0]), shifted(f[1]), shifted(f[2]), shifted(f[3])));
    });
    for_each_facet<3>([this](const Points<3>& facet, VertexId v, VertexId w) {
      if (!topology().is_infinite(w) && are_one(v, w)) return;
      const auto [a, b, c] = facet;
      Line<3> line = axis(a, b, c);
      for (const VertexId end : {v, w}) {
        if (topology().is_infinite(end)) continue;
        if (!(length(vertices_[index(end)]) >= length(line.anchor))) {
          line.anchor = vertices_[index(end)];
        }
      }
      const int side = orientation(position(a), position(b), position(c), position(apex(v, w)));
      add_voronoi_edge(line, v, w, side);
    });
  }

  bool are_one(VertexId v, VertexId w) const {
    const auto& f = topology().forming(v);
    return in_sphere(position(f[0]), position(f[1]), position(f[2]), position(f[3]),
                     position(apex(w, v))) == 0;
  }

  /// Finds the edges and rims of points in one plane: cells are prisms, whose edges stand upright
  /// on the plane.
  void find_walls_between_lines() {
    const auto any = topology().forming(tessellation_.structure().finite_vertex());
    const SceneVector upright = unit(normal(any[0], any[1], any[2]));
    place_vertices<2>([this](const auto& f) { return axis(f[0], f[1], f[2]).anchor; });
    topology().for_each_vertex([&](VertexId v) {
      if (!topology().is_infinite(v)) add_whole_line({vertices_[index(v)], upright});
    });
    for_each_facet<2>([&](const Points<2>& facet, VertexId v, VertexId w) {
      const auto [a, b] = facet;
      const SceneVector along = unit(cross(upright, step(a, b)));
      const Line<3> line{0.5 * (place(a) + place(b)), along};
      const int side = dot(step(a, apex(v, w)), along) > 0 ? 1 : -1;
      const Stretch s = stretch(line, v, w, side);
      const double from = std::clamp(s.from, -far_, far_);
      const double to = std::clamp(s.to, -far_, far_);
      if (from < to) add_rim(line.at(from), line.at(to), upright);
    });
  }

  /// Finds the rims of points on one line: cells are slabs.
  void find_parallel_walls() {
    const std::vector<PointId> line = tessellation_.along_line();
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const SceneVector along = unit(step(line[i], line[i + 1]));
      const auto least = std::min_element(
          along.begin(), along.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
      SceneVector other{};
      other[static_cast<std::size_t>(least - along.begin())] = 1;
      const SceneVector across = unit(cross(along, other));
      const SceneVector middle = 0.5 * (place(line[i]) + place(line[i + 1]));
      add_rim(middle - far_ * across, middle + far_ * across, cross(along, across));
    }
  }

  /// Adds the lines along which a wall leaves the box. The wall stands on the segment between two
  /// places, and reaches up and down without end.
  void add_rim(const SceneVector& from, const SceneVector& to, const SceneVector& upright) {
    const SceneVector rise = far_ * upright;
    const auto polygon = cut_to_box({from - rise, to - rise, to + rise, from + rise}, half_);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const SceneVector& p = polygon[i];
      const SceneVector& q = polygon[(i + 1) % polygon.size()];
      if (is_on_box(p, q)) edges.rims.push_back({p, q});
    }
  }

  bool is_on_box(const SceneVector& p, const SceneVector& q) const {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::abs(p[i]) == half_[i] && p[i] == q[i]) return true;
    }
    return false;
  }

  const double far_;  // a length that reaches beyond the box from anywhere in it
};

}  // namespace

TessellationEdges<2> edges_in_box(const Tessellation<2>& tessellation,
                                  const SceneCoordinates<2>& scene, const CoordinatesIn<2>& half) {
  PlaneEdgeFinder finder(tessellation, scene, half);
  finder.find_delaunay_edges();
  finder.find();
  return std::move(finder.edges);
}

TessellationEdges<3> edges_in_box(const Tessellation<3>& tessellation,
                                  const SceneCoordinates<3>& scene, const CoordinatesIn<3>& half) {
  SpaceEdgeFinder finder(tessellation, scene, half);
  finder.find_delaunay_edges();
  finder.find();
  return std::move(finder.edges);
}

}  // namespace thiessen

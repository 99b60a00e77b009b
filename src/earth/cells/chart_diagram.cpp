#include "earth/cells/chart_diagram.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "earth/cells/geodesic_vertices.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/sphere_tessellation.h"
#include "geometry/segment.h"

namespace thiessen {
namespace {

class ChartDiagramBuilder {
 public:
  ChartDiagramBuilder(const SphereTessellation& sphere, std::span<const Point> places,
                      const ChartGround& ground, const ChartAccuracy& accuracy)
      : sphere_(sphere),
        ground_(ground),
        accuracy_(accuracy),
        vertices_(sphere, places, ground.frame, accuracy.vertices, 1),
        node_of_(vertices_.mesh().triangles(), no_node),
        places_(places) {
    const double edge = std::tan(ground.reach);
    diagram_.frame = {{-edge, -edge}, {edge, edge}};
    diagram_.cell_of = sphere.cell_of();
    std::vector<Direction> directions;
    for (std::uint32_t p = 0; p < places.size(); ++p) {
      directions.push_back(sphere.direction(PlaceIndex{p}));
      diagram_.places.push_back(ground.chart.project(directions.back()));
    }
    diagram_.near = [directions = std::move(directions), cell_of = sphere.cell_of(),
                     chart = ground.chart](Point p) {
      const Direction at = chart.direction(p);
      std::size_t best = 0;
      for (std::size_t i = 1; i < directions.size(); ++i) {
        if (dot(directions[i], at) > dot(directions[best], at)) best = i;
      }
      return cell_of[best];
    };
  }

  Diagram build() && {
    const CellMesh& mesh = vertices_.mesh();
    mesh.for_each_edge(0, mesh.sides(), [this](SideIndex s) { add_edge(s); });
    vertices_.for_each_neighbours(
        [this](PlaceIndex a, PlaceIndex b) { diagram_.neighbours.emplace_back(a, b); });
    return std::move(diagram_);
  }

 private:
  struct End {
    double angle;
    std::uint32_t triangle;
    bool is_vertex;
  };
  /// The places on either side of an edge.
  struct Sides {
    EarthPoint left;
    EarthPoint right;
  };
  /// How far an edge lies from its chord.
  struct Bend {
    double area = 0;      ///< square metres, positive to the right
    double farthest = 0;  ///< metres
  };

  void add_edge(SideIndex s) {
    const auto border = vertices_.border(s);
    if (!border) return;
    const auto& [left, right, start, end] = *border;
    const GeodesicBisector edge = vertices_.edge(left, right);
    const auto [from, to] = vertices_.angles(edge, start, end);
    End first{from, start, vertices_.is_exact(start)};
    End last{to, end, vertices_.is_exact(end)};
    if (!cut_to_reach(edge.arc(), first, last)) return;
    const Sides sides{{places_[index(left)], sphere_.direction(left)},
                      {places_[index(right)], sphere_.direction(right)}};
    const std::uint32_t from_node = node_at(edge, first, sides);
    const std::uint32_t to_node = node_at(edge, last, sides);
    throw_if_interrupted();
    add_chords({from_node, to_node, left, right}, sides);
  }

  // Adds as many chords as are needed to keep the edge within `bends` of each of them.
  void add_chords(const Chord& whole, const Sides& sides) {
    const Bend bend = bend_of(diagram_.nodes[whole.from], diagram_.nodes[whole.to], sides);
    constexpr double most_chords = 1000;
    const double chords =
        std::clamp(std::ceil(std::sqrt(bend.farthest / accuracy_.bends)), 1.0, most_chords);
    if (chords == 1) {
      diagram_.chords.push_back(whole);
      diagram_.bulges.push_back(bend.area);
      return;
    }
    const Point from = diagram_.nodes[whole.from];
    const Point to = diagram_.nodes[whole.to];
    const Direction to_right = to_right_of(from, to);
    std::uint32_t before = whole.from;
    for (int i = 1; i <= static_cast<int>(chords); ++i) {
      std::uint32_t next = whole.to;
      if (i < static_cast<int>(chords)) {
        const Direction at = ground_.chart.direction(between(from, to, i / chords));
        next = new_node(on_edge(at, to_right, sides));
      }
      diagram_.chords.push_back({before, next, whole.left, whole.right});
      diagram_.bulges.push_back(bend_of(diagram_.nodes[before], diagram_.nodes[next], sides).area);
      before = next;
    }
  }

  // Cuts the edge to the part within reach of the chart's centre; false where nothing is left.
  bool cut_to_reach(const BisectorArc& arc, End& first, End& last) const {
    const Direction centre = ground_.chart.centre();
    const double along_middle = dot(arc.at(0), centre);
    const double along_left = dot(arc.at(std::numbers::pi / 2), centre);
    const double height = std::hypot(along_middle, along_left);
    const double cosine = std::cos(ground_.reach);
    if (height <= cosine) return false;
    const double half = std::acos(cosine / height);
    const double middle = first.angle + (last.angle - first.angle) / 2;
    const double nearest = middle + std::remainder(std::atan2(along_left, along_middle) - middle,
                                                   2 * std::numbers::pi);
    if (nearest - half > first.angle) first = {nearest - half, 0, false};
    if (nearest + half < last.angle) last = {nearest + half, 0, false};
    return first.angle < last.angle;
  }

  std::uint32_t node_at(const GeodesicBisector& edge, const End& end, const Sides& sides) {
    if (!end.is_vertex)
      return new_node(on_edge(edge.arc().at(end.angle), edge.arc().forward(), sides));
    std::uint32_t& node = node_of_[end.triangle];
    if (node == no_node) node = new_node(vertices_.direction(end.triangle));
    return node;
  }

  std::uint32_t new_node(Direction at) {
    diagram_.nodes.push_back(ground_.chart.project(at));
    return static_cast<std::uint32_t>(diagram_.nodes.size() - 1);
  }

  // Metres to the edge from a point near it: the difference of the two distances, divided by the
  // rate at which it changes across the edge.
  double offset_at(Direction at, Direction to_right, const Sides& sides) const {
    const SphereArrival from_left = sphere_arrival(sides.left, at, accuracy_.vertices);
    const SphereArrival from_right = sphere_arrival(sides.right, at, accuracy_.vertices);
    const double growth = dot(from_left.onward - from_right.onward, to_right);
    return growth > 0 ? (from_right.distance - from_left.distance) / growth : 0;
  }

  // Moves a point near the edge straight onto it. The error that a step leaves is of the second
  // order in the step, so a second step follows only a long first one.
  Direction on_edge(Direction at, Direction to_right, const Sides& sides) const {
    constexpr double far = 1;  // metres
    const double offset = offset_at(at, to_right, sides);
    const auto moved = [&](double metres) {
      const double angle = metres / scale_on_earth(at.z);
      return std::cos(angle) * at + std::sin(angle) * to_right;
    };
    const Direction near = moved(offset);
    if (std::abs(offset) <= far) return near;
    return moved(offset + offset_at(near, to_right, sides));
  }

  /// The unit vector across the great circle of a chord, to its right; zero for a chord without
  /// length.
  Direction to_right_of(Point from, Point to) const {
    const Direction normal = cross(ground_.chart.direction(to), ground_.chart.direction(from));
    const double sine = length(normal);
    return sine > 0 ? (1 / sine) * normal : Direction{};
  }

  Bend bend_of(Point from, Point to, const Sides& sides) const {
    const Direction start = ground_.chart.direction(from);
    const Direction end = ground_.chart.direction(to);
    const Direction to_right = to_right_of(from, to);
    Bend bend;
    double mean = 0;
    for (const BooleSample& x : boole_samples) {
      const double offset =
          offset_at(ground_.chart.direction(between(from, to, x.along)), to_right, sides);
      mean += x.weight * offset;
      bend.farthest = std::max(bend.farthest, std::abs(offset));
    }
    const double angle = 2 * std::asin(std::min(1.0, length(end - start) / 2));
    bend.area = mean * angle * scale_on_earth(unit(start + end).z);
    return bend;
  }

  const SphereTessellation& sphere_;
  const ChartGround& ground_;
  ChartAccuracy accuracy_;
  GeodesicVertices vertices_;
  std::vector<std::uint32_t> node_of_;
  std::span<const Point> places_;
  Diagram diagram_;
};

}  // namespace

std::optional<Diagram> chart_diagram(std::span<const Point> places, const ChartGround& ground,
                                     const ChartAccuracy& accuracy) {
  constexpr double nearly_beyond = 0.17;
  const SphereTessellation sphere(places);
  if (sphere.tessellation().span() != Span::plane) return {};
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    if (dot(sphere.direction(PlaceIndex{p}), ground.chart.centre()) < nearly_beyond) return {};
  }
  return ChartDiagramBuilder(sphere, places, ground, accuracy).build();
}

}  // namespace thiessen

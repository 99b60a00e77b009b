#include "earth/chart_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "earth/geodesic.h"
#include "earth/geodesic_vertices.h"
#include "earth/sphere_tessellation.h"

namespace thiessen {
namespace {

// Of the rule by G. Boole for what is 0 at both ends.
struct Abscissa {
  double along;
  double weight;
};
constexpr std::array<Abscissa, 3> boole{{{0.25, 32. / 90}, {0.5, 12. / 90}, {0.75, 32. / 90}}};

class ChartDiagramBuilder {
 public:
  ChartDiagramBuilder(const SphereTessellation& sphere, std::span<const Point> places,
                      const ChartGround& ground, double accuracy)
      : sphere_(sphere),
        ground_(ground),
        accuracy_(accuracy),
        vertices_(sphere, places, ground.frame, accuracy, 1),
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
    for (std::uint32_t i = 0; i < mesh.sides(); ++i) {
      if (SideIndex{i} < mesh.twin(SideIndex{i})) add_edge(SideIndex{i});
    }
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

  // From the vertex to the right of the way between the two places to the one on the left.
  void add_edge(SideIndex s) {
    const CellMesh& mesh = vertices_.mesh();
    std::uint32_t start = vertices_.group_of(CellMesh::triangle_of(mesh.twin(s)));
    std::uint32_t end = vertices_.group_of(CellMesh::triangle_of(s));
    if (start == end) return;
    PlaceIndex left = mesh.from(s);
    PlaceIndex right = mesh.to(s);
    // One way only, so that rounding is the same for any order of places.
    if (places_[index(right)] < places_[index(left)]) {
      std::swap(left, right);
      std::swap(start, end);
    }
    const GeodesicBisector edge = vertices_.edge(left, right);
    const auto [from, to] = vertices_.angles(edge, start, end);
    End first{from, start, vertices_.is_exact(start)};
    End last{to, end, vertices_.is_exact(end)};
    if (!cut_to_reach(edge.arc(), first, last)) return;
    const EarthPoint left_place(places_[index(left)], sphere_.direction(left));
    const EarthPoint right_place(places_[index(right)], sphere_.direction(right));
    const std::uint32_t from_node = node_at(edge, first, left_place, right_place);
    const std::uint32_t to_node = node_at(edge, last, left_place, right_place);
    diagram_.chords.push_back({from_node, to_node, left, right});
    diagram_.bulges.push_back(
        bulge_of(diagram_.nodes[from_node], diagram_.nodes[to_node], left_place, right_place));
  }

  // What is within reach of the centre, where anything is.
  bool cut_to_reach(const BisectorArc& arc, End& first, End& last) const {
    const Direction centre = ground_.chart.centre();
    const double along_middle = dot(arc.at(0), centre);
    const double along_left = dot(arc.at(std::numbers::pi / 2), centre);
    const double height = std::hypot(along_middle, along_left);
    const double cosine = std::cos(ground_.reach);
    if (height <= cosine) return false;
    const double half = std::acos(cosine / height);
    const double between = first.angle + (last.angle - first.angle) / 2;
    const double nearest = between + std::remainder(std::atan2(along_left, along_middle) - between,
                                                    2 * std::numbers::pi);
    if (nearest - half > first.angle) first = {nearest - half, 0, false};
    if (nearest + half < last.angle) last = {nearest + half, 0, false};
    return first.angle < last.angle;
  }

  std::uint32_t node_at(const GeodesicBisector& edge, const End& end, const EarthPoint& left,
                        const EarthPoint& right) {
    if (!end.is_vertex) {
      const Direction at = edge.arc().at(end.angle);
      const double offset = offset_at(at, edge.arc().forward(), left, right) / scale_on_earth(at.z);
      return new_node(edge.arc().at(end.angle, offset));
    }
    std::uint32_t& node = node_of_[end.triangle];
    if (node == no_node) node = new_node(vertices_.direction(end.triangle));
    return node;
  }

  std::uint32_t new_node(Direction at) {
    diagram_.nodes.push_back(ground_.chart.project(at));
    return static_cast<std::uint32_t>(diagram_.nodes.size() - 1);
  }

  // Metres to the edge from a point near it: their distances' difference over what it grows by.
  double offset_at(Direction at, Direction to_right, const EarthPoint& left,
                   const EarthPoint& right) const {
    const SphereArrival from_left = sphere_arrival(left, at, accuracy_);
    const SphereArrival from_right = sphere_arrival(right, at, accuracy_);
    const double growth = dot(from_left.onward - from_right.onward, to_right);
    return growth > 0 ? (from_right.distance - from_left.distance) / growth : 0;
  }

  double bulge_of(Point from, Point to, const EarthPoint& left, const EarthPoint& right) const {
    const Direction start = ground_.chart.direction(from);
    const Direction end = ground_.chart.direction(to);
    const Direction normal = cross(start, end);
    const double sine = length(normal);
    if (sine == 0) return 0;
    const Direction to_right = (-1 / sine) * normal;
    double mean = 0;
    for (const Abscissa& x : boole) {
      const Point p{from.x + x.along * (to.x - from.x), from.y + x.along * (to.y - from.y)};
      mean += x.weight * offset_at(ground_.chart.direction(p), to_right, left, right);
    }
    const Direction middle = unit(start + end);
    return mean * std::asin(std::min(1.0, sine)) * scale_on_earth(middle.z);
  }

  const SphereTessellation& sphere_;
  const ChartGround& ground_;
  double accuracy_;
  GeodesicVertices vertices_;
  std::vector<std::uint32_t> node_of_;
  std::span<const Point> places_;
  Diagram diagram_;
};

}  // namespace

std::optional<Diagram> chart_diagram(std::span<const Point> places, const ChartGround& ground,
                                     double accuracy) {
  constexpr double nearly_beyond = 0.17;
  const SphereTessellation sphere(places);
  if (sphere.tessellation().span() != Span::plane) return {};
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    if (dot(sphere.direction(PlaceIndex{p}), ground.chart.centre()) < nearly_beyond) return {};
  }
  return ChartDiagramBuilder(sphere, places, ground, accuracy).build();
}

}  // namespace thiessen

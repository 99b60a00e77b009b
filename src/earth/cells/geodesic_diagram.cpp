#include "earth/cells/geodesic_diagram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "earth/cells/cell_mesh.h"
#include "earth/cells/edge_drawing.h"
#include "earth/cells/equidistance.h"
#include "earth/cells/geodesic_vertices.h"
#include "earth/cells/longitude_turn.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/sphere_tessellation.h"

namespace thiessen {
namespace {

constexpr double pi = std::numbers::pi;

class GeodesicDiagramBuilder {
 public:
  GeodesicDiagramBuilder(std::span<const Point> places, const Box& frame, double tolerance,
                         double accuracy, unsigned threads)
      : sphere_(std::make_shared<SphereTessellation>(places)),
        tolerance_(tolerance),
        accuracy_(accuracy),
        threads_(threads) {
    diagram_.frame = frame;
    diagram_.period = 360;
    diagram_.places.assign(places.begin(), places.end());
    diagram_.cell_of = sphere_->cell_of();
    diagram_.near = [sphere = sphere_](Point p) {
      return sphere->cell_of()[index(sphere->nearest_on_earth(p))];
    };
  }

  Diagram build() && {
    const Span span = sphere_->tessellation().span();
    if (span == Span::point) add_closed_edge();
    if (span == Span::line || span == Span::plane) add_edges();
    for (std::uint32_t p = 0; p < diagram_.places.size(); ++p) {
      const PlaceIndex cell = diagram_.cell_of[p];
      if (index(cell) != p) diagram_.neighbours.emplace_back(cell, PlaceIndex{p});
    }
    return std::move(diagram_);
  }

 private:
  Point position(PlaceIndex p) const { return diagram_.places[index(p)]; }

  // Two places share a single edge that closes on itself.
  void add_closed_edge() {
    const PlaceIndex first = sphere_->pole();
    const PlaceIndex second = sphere_->place(sphere_->tessellation().along_line().front());
    diagram_.neighbours.emplace_back(first, second);
    const GeodesicBisector edge(EarthPoint(position(first)), EarthPoint(position(second)),
                                sphere_->bisector(first, second), accuracy_);
    const Point start = LongitudeTurn(diagram_.frame).within(edge.find(pi).position);
    diagram_.nodes.push_back(start);
    EdgeDrawing drawing(diagram_.frame, tolerance_, 1);
    drawing.draw(edge, {-pi, 0, start}, {pi, 0, start}, first, second);
    drawing.add_to(diagram_);
    LongitudeTurn(diagram_.frame).draw_on_both_sides(diagram_);
  }

  void add_edges() {
    GeodesicVertices vertices(*sphere_, diagram_.places, diagram_.frame, accuracy_, threads_);
    const LongitudeTurn longitudes(diagram_.frame);
    const CellMesh& mesh = vertices.mesh();
    std::vector<std::uint32_t> node(mesh.triangles(), no_node);
    for (std::uint32_t t = 0; t < mesh.triangles(); ++t) {
      const std::uint32_t group = vertices.group_of(t);
      if (node[group] == no_node) {
        node[group] = static_cast<std::uint32_t>(diagram_.nodes.size());
        diagram_.nodes.push_back(longitudes.within(vertices.position(group)));
      }
      node[t] = node[group];
    }
    draw(vertices, node);
    longitudes.draw_on_both_sides(diagram_);
    vertices.for_each_neighbours(
        [this](PlaceIndex a, PlaceIndex b) { diagram_.neighbours.emplace_back(a, b); });
  }

  // Sides are drawn in pieces of a fixed length, so that the nodes' numbers do not depend on the
  // number of threads.
  void draw(const GeodesicVertices& vertices, const std::vector<std::uint32_t>& node) {
    constexpr std::uint32_t sides_a_piece = 3000;
    const CellMesh& mesh = vertices.mesh();
    const auto vertex_nodes = static_cast<std::uint32_t>(diagram_.nodes.size());
    const std::size_t pieces = (mesh.sides() + sides_a_piece - 1) / sides_a_piece;
    std::vector<EdgeDrawing> drawings(pieces,
                                      EdgeDrawing(diagram_.frame, tolerance_, vertex_nodes));
    in_parallel(pieces, threads_, [&](std::size_t, std::size_t piece) {
      const auto first = static_cast<std::uint32_t>(piece * sides_a_piece);
      const std::uint32_t end = std::min(mesh.sides(), first + sides_a_piece);
      mesh.for_each_edge(first, end,
                         [&](SideIndex s) { draw_edge(vertices, node, s, drawings[piece]); });
    });
    for (const EdgeDrawing& drawing : drawings) drawing.add_to(diagram_);
  }

  void draw_edge(const GeodesicVertices& vertices, const std::vector<std::uint32_t>& node,
                 SideIndex s, EdgeDrawing& drawing) const {
    const auto border = vertices.border(s);
    if (!border) return;
    const auto& [left, right, start, end] = *border;
    const GeodesicBisector edge = vertices.edge(left, right);
    const auto [from, to] = vertices.angles(edge, start, end);
    drawing.draw(edge, {from, node[start], diagram_.nodes[node[start]]},
                 {to, node[end], diagram_.nodes[node[end]]}, left, right);
  }

  std::shared_ptr<const SphereTessellation> sphere_;
  double tolerance_;
  double accuracy_;
  unsigned threads_;
  Diagram diagram_;
};

}  // namespace

Diagram geodesic_diagram(std::span<const Point> places, const Box& frame, double tolerance,
                         double accuracy, unsigned threads) {
  return GeodesicDiagramBuilder(places, frame, tolerance, accuracy, threads).build();
}

}  // namespace thiessen

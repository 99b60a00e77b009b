#include "tessellation/topology_table.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/number.h"
#include "geometry/coordinates.h"
#include "tessellation/points_by_number.h"
#include "tessellation/voronoi_vertex.h"

namespace thiessen {
namespace {

void append_number(std::string& line, double value) {
  line += ' ';
  if (std::isfinite(value)) {
    append_shortest(line, value);
  } else {
    line += value > 0 ? "infinity" : "-infinity";
  }
}
template <typename Position>
void append_position(std::string& line, const Position& position) {
  for (const double coordinate : coordinates(position)) append_number(line, coordinate);
}
template <typename Position>
std::string text_of(const Position& position) {
  std::string text;
  append_position(text, position);
  return text.substr(1);
}
void append_count(std::string& line, std::uint64_t number) {
  line += ' ';
  line += std::to_string(number);
}

std::uint64_t number_of_vertex(VertexId v) {
  return std::uint64_t{index(v)} + 1;
}

/// Appends `vertex ID center X Y [Z] radius R`, without a line end.
template <int Dimension>
void append_vertex(std::string& line, const VoronoiVertex<Dimension>& vertex) {
  line += "vertex";
  append_count(line, number_of_vertex(vertex.vertex));
  line += " center";
  append_position(line, vertex.centre);
  line += " radius";
  append_number(line, vertex.radius);
}

template <int Dimension>
void append_row(std::string& line, const Topology<Dimension>& topology, const NumberOf& number_of,
                VertexId v) {
  line += " forming";
  for (const PointId p : topology.forming(v)) append_count(line, number_of(p));
  line += " neighbors";
  for (const VertexId w : topology.row(v).neighbours)
    append_count(line, topology.is_infinite(w) ? 0 : number_of_vertex(w));
  line += '\n';
}

template <typename Cell>
std::string vertices_and_rays(const Cell& cell) {
  std::string text;
  for (const auto& vertex : cell.vertices) {
    throw_if_interrupted();
    append_vertex(text, vertex);
    text += '\n';
  }
  for (const auto& ray : cell.rays) {
    text += "ray from";
    append_count(text, number_of_vertex(cell.vertices[ray.from].vertex));
    text += " direction";
    append_position(text, ray.direction);
    text += '\n';
  }
  return text;
}

void append_measure(std::string& text, const char* name, double value) {
  text += name;
  append_number(text, value);
}

}  // namespace

std::string position_text(const Point& position) {
  return text_of(position);
}
std::string position_text(const SpacePoint& position) {
  return text_of(position);
}

template <int Dimension>
std::string point_line(const Tessellation<Dimension>& tessellation, const NumberOf& number_of,
                       PointId p) {
  std::string line = "point";
  append_count(line, number_of(p));
  append_position(line, tessellation.position(p));
  return line += '\n';
}

template <int Dimension>
void write_topology_table(const Tessellation<Dimension>& tessellation, const NumberOf& number_of,
                          const TextSink& write) {
  const auto& topology = tessellation.topology();
  for (const auto& [number, p] : points_by_number(tessellation, number_of))
    write(point_line(tessellation, number_of, p));
  if (topology.dimension() < Dimension) return;
  std::string line;
  topology.for_each_vertex([&](VertexId v) {
    if (topology.is_infinite(v)) return;
    line.clear();
    append_vertex(line, voronoi_vertex(tessellation.structure(), v));
    append_row(line, topology, number_of, v);
    write(line);
  });
}

std::string cell_text(const Tessellation<2>& tessellation, const NumberOf& number_of,
                      const PlaneCell& cell) {
  std::string text = point_line(tessellation, number_of, cell.point) + vertices_and_rays(cell);
  append_measure(text, "area", cell.area);
  text += "\nneighbors";
  for (const PointId q : cell.neighbours) append_count(text, number_of(q));
  return text += '\n';
}

std::string cell_text(const Tessellation<3>& tessellation, const NumberOf& number_of,
                      const SpaceCell& cell) {
  std::string text = point_line(tessellation, number_of, cell.point) + vertices_and_rays(cell);
  std::vector<std::pair<std::uint64_t, const CellFace*>> faces;
  for (const CellFace& face : cell.faces) faces.emplace_back(number_of(face.neighbour), &face);
  std::sort(faces.begin(), faces.end());
  std::string neighbours;
  for (const auto& [number, face] : faces) {
    throw_if_interrupted();
    append_count(neighbours, number);
    text += "face neighbor";
    append_count(text, number);
    append_measure(text, " area", face->area);
    text += " vertices";
    for (const std::size_t i : face->vertices)
      append_count(text, number_of_vertex(cell.vertices[i].vertex));
    text += '\n';
  }
  append_measure(text, "volume", cell.volume);
  return text += "\nneighbors" + neighbours + '\n';
}

#define THIESSEN_TOPOLOGY_TABLE(D)                                                   \
  template std::string point_line(const Tessellation<D>&, const NumberOf&, PointId); \
  template void write_topology_table(const Tessellation<D>&, const NumberOf&, const TextSink&);

THIESSEN_TOPOLOGY_TABLE(2)
THIESSEN_TOPOLOGY_TABLE(3)

}  // namespace thiessen

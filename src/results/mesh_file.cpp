#include "results/mesh_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "base/destination.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "base/utf8.h"
#include "base/version.h"
#include "geometry/coordinates.h"
#include "tessellation/cell.h"
#include "tessellation/points_by_number.h"

namespace thiessen {
namespace {

/// The faces of a simplex as corners of its row: the triangle itself, or the four faces of a
/// tetrahedron, counter-clockwise from outside.
constexpr std::array<std::array<std::size_t, 3>, 1> triangle = {{{0, 1, 2}}};
constexpr std::array<std::array<std::size_t, 3>, 4> faces_of_tetrahedron = {
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

template <int Dimension>
constexpr const auto& faces() {
  if constexpr (Dimension == 2) {
    return triangle;
  } else {
    return faces_of_tetrahedron;
  }
}

template <typename Position>
void append_position(std::string& line, const Position& position) {
  const auto at = coordinates(position);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis > 0) line += ' ';
    append_shortest(line, axis < at.size() ? at[axis] : 0);
  }
}

template <int Dimension>
class MeshWriter {
 public:
  MeshWriter(OutputFile& file, const Tessellation<Dimension>& tessellation,
             const NumberOf& number_of)
      : file_(file),
        tessellation_(tessellation),
        topology_(tessellation.topology()),
        number_of_(number_of),
        points_(points_by_number(tessellation, number_of)),
        place_(topology_.point_limit()) {
    for (std::size_t i = 0; i < points_.size(); ++i) place_[index(points_[i].second)] = i;
  }

  void write_obj() {
    line_ = "# made by thiessen " + std::string(version()) + "\no delaunay\n";
    put();
    for (const auto& [number, p] : points_) put_obj_vertex(tessellation_.position(p));
    for_each_simplex([&](VertexId v) {
      if constexpr (Dimension == 3) {
        line_ = "g tetrahedron_" + std::to_string(index(v) + 1) + "\n";
        put();
      }
      for (const auto& corners : faces<Dimension>()) {
        line_ = "f";
        for (const std::size_t corner : corners)
          line_ += ' ' + std::to_string(place_of(v, corner) + 1);
        line_ += '\n';
        put();
      }
    });
    if constexpr (Dimension == 3) write_obj_cells();
  }

  void write_ply() {
    std::size_t simplices = 0;
    for_each_simplex([&](VertexId) { ++simplices; });
    const std::uint64_t largest = points_.empty() ? 0 : points_.back().first;
    const bool is_small = largest <= std::numeric_limits<std::uint32_t>::max();
    line_ = "ply\nformat ascii 1.0\ncomment made by thiessen " + std::string(version()) +
            "\nelement vertex " + std::to_string(points_.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\nproperty " +
            (is_small ? "uint" : "double") + " number\nelement face " +
            std::to_string(simplices * faces<Dimension>().size()) +
            "\nproperty list uchar int vertex_indices\nend_header\n";
    put();
    for (const auto& [number, p] : points_) {
      line_.clear();
      append_position(line_, tessellation_.position(p));
      line_ += ' ' + std::to_string(number) + '\n';
      put();
    }
    for_each_simplex([&](VertexId v) {
      for (const auto& corners : faces<Dimension>()) {
        line_ = "3";
        for (const std::size_t corner : corners) line_ += ' ' + std::to_string(place_of(v, corner));
        line_ += '\n';
        put();
      }
    });
  }

  void write_geojson() {
    line_ = R"({"type":"FeatureCollection","made_by":{"software":"thiessen )" +
            std::string(version()) + R"("},"features":[)";
    put();
    const char* before = "\n";
    for_each_simplex([&](VertexId v) {
      const auto& forming = topology_.forming(v);
      line_ = std::exchange(before, ",\n");
      line_ += R"({"type":"Feature","properties":{)";
      constexpr std::array<const char*, 3> names = {R"("a":)", R"(,"b":)", R"(,"c":)"};
      for (std::size_t i = 0; i < names.size(); ++i)
        line_ += names.at(i) + std::to_string(number_of_(forming[i]));
      line_ += R"(},"geometry":{"type":"Polygon","coordinates":[[)";
      for (const std::size_t i : {0U, 1U, 2U, 0U}) {
        const auto at = coordinates(tessellation_.position(forming[i]));
        line_ += line_.back() == '[' ? "[" : ",[";
        append_shortest(line_, at[0]);
        line_ += ',';
        append_shortest(line_, at[1]);
        line_ += ']';
      }
      line_ += "]]}}";
      put();
    });
    line_ = "\n]}\n";
    put();
  }

 private:
  void put() { file_.append(line_); }
  template <typename Position>
  void put_obj_vertex(const Position& position) {
    throw_if_interrupted();
    line_ = "v ";
    append_position(line_, position);
    line_ += '\n';
    put();
  }
  std::size_t place_of(VertexId v, std::size_t corner) const {
    return place_[index(topology_.forming(v)[corner])];
  }
  template <typename Visit>
  void for_each_simplex(Visit&& visit) const {
    if (topology_.dimension() < Dimension) return;
    topology_.for_each_vertex([&](VertexId v) {
      throw_if_interrupted();
      if (!topology_.is_infinite(v)) visit(v);
    });
  }

  // A face's corners are named by VertexId; every vertex stands in the file once. A cell with a
  // corner beyond the doubles is left out, as unbounded ones are.
  void write_obj_cells() requires(Dimension == 3) {
    line_ = "o voronoi\n";
    put();
    std::vector<std::size_t> row(topology_.size(), 0);
    std::size_t rows = points_.size();
    for_each_simplex([&](VertexId v) {
      const SpacePoint centre = voronoi_vertex(tessellation_.structure(), v).centre;
      if (!is_finite(centre)) return;
      row[index(v)] = ++rows;
      put_obj_vertex(centre);
    });
    for (const auto& [number, p] : points_) {
      throw_if_interrupted();
      const SpaceCell cell = find_cell(tessellation_, p);
      const bool is_told = cell.is_bounded && !cell.faces.empty() &&
                           std::all_of(cell.vertices.begin(), cell.vertices.end(),
                                       [](const auto& v) { return is_finite(v.centre); });
      if (!is_told) continue;
      line_ = "g cell_" + std::to_string(number) + "\n";
      for (const CellFace& face : cell.faces) {
        line_ += "f";
        for (const std::size_t i : face.vertices)
          line_ += ' ' + std::to_string(row[index(cell.vertices[i].vertex)]);
        line_ += '\n';
      }
      put();
    }
  }
  static bool is_finite(const SpacePoint& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  }

  OutputFile& file_;
  const Tessellation<Dimension>& tessellation_;
  const Topology<Dimension>& topology_;
  const NumberOf& number_of_;
  std::vector<std::pair<std::uint64_t, PointId>> points_;
  std::vector<std::size_t> place_;  // by point, its place among the points of the file, from 0
  std::string line_;
};

}  // namespace

template <int Dimension>
MeshFormat mesh_format(const std::string& path) {
  constexpr const char* formats = Dimension == 2
                                      ? "triangles are written as .obj, .ply or .geojson"
                                      : "tetrahedra are written as .obj (with the cells) or .ply";
  const std::string name = lower_case(name_in_folder(path));
  if (name.ends_with(".obj")) return MeshFormat::obj;
  if (name.ends_with(".ply")) return MeshFormat::ply;
  if (!name.ends_with(".geojson"))
    throw Error(
        Message{path, 0, "no format of triangles or tetrahedra has this extension", formats});
  if (Dimension == 3) throw Error(Message{path, 0, "GeoJSON has no tetrahedra", formats});
  return MeshFormat::geojson;
}

template <int Dimension>
void write_mesh(OutputFile& file, MeshFormat format, const Tessellation<Dimension>& tessellation,
                const NumberOf& number_of) {
  MeshWriter<Dimension> writer(file, tessellation, number_of);
  switch (format) {
    case MeshFormat::obj:
      return writer.write_obj();
    case MeshFormat::ply:
      return writer.write_ply();
    case MeshFormat::geojson:
      return writer.write_geojson();
  }
}

#define THIESSEN_MESH_FILE(D)                             \
  template MeshFormat mesh_format<D>(const std::string&); \
  template void write_mesh(OutputFile&, MeshFormat, const Tessellation<D>&, const NumberOf&);

THIESSEN_MESH_FILE(2)
THIESSEN_MESH_FILE(3)

}  // namespace thiessen

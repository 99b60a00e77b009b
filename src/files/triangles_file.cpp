#include "files/triangles_file.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/interrupt.h"
#include "base/utf8.h"
#include "files/shape_target.h"
#include "gdal/output/layer_formats.h"
#include "gdal/output/triangles_layer.h"
#include "outlines/vertex_rounding.h"
#include "results/triangles_geojson.h"

namespace thiessen {
namespace {

std::string name_of(const TriangleFeature& triangle) {
  const auto& [a, b, c] = triangle.stations;
  return "the triangle of stations " + quoted(a, 80) + ", " + quoted(b, 80) + " and " +
         quoted(c, 80);
}

std::vector<MultiPolygon> shapes_in(const TrianglesOutput& output,
                                    const std::optional<Crs>& target) {
  std::vector<MultiPolygon> shapes;
  shapes.reserve(output.triangles.size());
  ShapeTarget in_target(output.study_crs, target, output.tolerance);
  for (const TriangleFeature& triangle : output.triangles) {
    throw_if_interrupted();
    shapes.push_back(in_target.of(triangle.shape, name_of(triangle), "triangles"));
  }
  return shapes;
}

void tell_lost(const TrianglesOutput& output, const std::vector<MultiPolygon>& shapes,
               const std::string& file, Warnings& warnings) {
  const auto is_lost = [](const MultiPolygon& shape) { return shape.empty(); };
  const auto lost = std::count_if(shapes.begin(), shapes.end(), is_lost);
  if (lost == 0) return;
  const auto first = std::find_if(shapes.begin(), shapes.end(), is_lost);
  std::string text = name_of(output.triangles[static_cast<std::size_t>(first - shapes.begin())]);
  if (lost > 1) text += ", and " + std::to_string(lost - 1) + " more,";
  warnings.add(
      {file, 0, text + " has no geometry: it is narrower than the coordinates can tell", {}});
}

/// The shapes in `target` that are valid in doubles; the others are empty.
std::vector<MultiPolygon> valid_shapes_in(const TrianglesOutput& output,
                                          const std::optional<Crs>& target) {
  std::vector<MultiPolygon> shapes = shapes_in(output, target);
  for (MultiPolygon& shape : shapes) {
    throw_if_interrupted();
    if (!is_writable(shape)) shape.clear();
  }
  return shapes;
}

}  // namespace

std::string triangles_geojson(const TrianglesOutput& output, const std::string& file,
                              Warnings& warnings) {
  if (!output.study_crs) {
    const std::vector<MultiPolygon> shapes = valid_shapes_in(output, {});
    tell_lost(output, shapes, file, warnings);
    return triangles_geojson(output, shapes, VertexRounding());
  }
  std::vector<MultiPolygon> shapes = shapes_in(output, Crs::wgs84());
  const VertexRounding rounding(shapes, decimals_for(output.tolerance));
  for (const std::size_t i : rounding.faulty()) shapes[i].clear();
  tell_lost(output, shapes, file, warnings);
  return triangles_geojson(output, shapes, rounding);
}

std::vector<EncodedFile> triangles_files(const TrianglesOutput& output, const std::string& path,
                                         Warnings& warnings, const std::string& older) {
  const std::string extension = extension_of(path);
  if (extension == "geojson" || extension == "json")
    return {{path, triangles_geojson(output, path, warnings)}};
  std::optional<Crs> crs = output.file_crs ? output.file_crs : output.study_crs;
  require_known_degrees(path, output.study_crs.has_value());
  if (holds_degrees_only(extension)) crs = Crs::wgs84();
  const std::vector<MultiPolygon> shapes = valid_shapes_in(output, crs);
  tell_lost(output, shapes, path, warnings);
  return write_triangles_layer(output, shapes, crs, path, older, warnings);
}

}  // namespace thiessen

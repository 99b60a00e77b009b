#include "gdal/output/isohyets_file.h"

#include <ogr_geometry.h>

#include <memory>
#include <span>

#include "gdal/output/layer_formats.h"
#include "gdal/output/vector_layer.h"
#include "outlines/antimeridian.h"

namespace thiessen {
namespace {

/// The lines of an isohyet; of degrees each longitude lies in [-180, 180].
std::unique_ptr<OGRGeometry> geometry_of(const Isohyet& isohyet, bool is_in_degrees) {
  auto lines = std::make_unique<OGRMultiLineString>();
  const auto add = [&](std::span<const Point> points) {
    auto line = std::make_unique<OGRLineString>();
    for (const Point p : points) line->addPoint(p.x, p.y);
    lines->addGeometryDirectly(line.release());
  };
  for (const std::vector<Point>& points : isohyet.lines) {
    if (!is_in_degrees) {
      add(points);
      continue;
    }
    for (const std::vector<Point>& piece : cut_at_antimeridian(points)) add(piece);
  }
  return lines;
}

}  // namespace

std::vector<EncodedFile> isohyets_file(std::span<const Isohyet> isohyets,
                                       std::span<const std::string> basin_ids,
                                       const std::optional<Crs>& crs, const Provenance& made_by,
                                       const std::string& path, const std::string& older,
                                       Warnings& warnings) {
  require_known_degrees(path, crs.has_value());
  if (!crs) {
    warnings.add({path, 0, "the isohyets are in the plane's own coordinates: no CRS is known", ""});
  }
  VectorLayer layer;
  layer.name = "isohyets";
  layer.shapes = VectorLayer::Shapes::lines;
  layer.fields = {{"basin", FieldType::text}, {"rainfall", FieldType::real}};
  layer.own_fields = layer.fields.size();
  layer.values.rows = isohyets.size();
  layer.values.names = {"basin", "rainfall"};
  layer.values.text = [&](std::size_t row, std::size_t field) {
    return field == 0 ? basin_ids[isohyets[row].basin] : std::string();
  };
  layer.values.number = [&](std::size_t row, std::size_t field) {
    return field == 1 ? std::optional(isohyets[row].level) : std::nullopt;
  };
  const bool is_in_degrees = crs && crs->degrees_per_unit() == 1;
  layer.shape = [&](std::size_t row) { return geometry_of(isohyets[row], is_in_degrees); };
  layer.made_by = made_by;
  return write_vector_layer(layer, crs, path, older, warnings);
}

}  // namespace thiessen

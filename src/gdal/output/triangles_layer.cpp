#include "gdal/output/triangles_layer.h"

#include <ogr_geometry.h>

#include <cstddef>

#include "base/utf8.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/output/vector_layer.h"
#include "gdal/output/written_validity.h"

namespace thiessen {

std::vector<EncodedFile> write_triangles_layer(const TriangleFeatures& features,
                                               std::span<const MultiPolygon> shapes,
                                               const std::optional<Crs>& crs,
                                               const std::string& path, const std::string& older,
                                               Warnings& warnings) {
  VectorLayer layer;
  layer.name = "delaunay";
  for (const char* const name : corner_names) {
    layer.fields.push_back({name, FieldType::text});
    layer.values.names.emplace_back(name);
  }
  layer.own_fields = layer.fields.size();
  layer.values.rows = features.triangles.size();
  layer.values.text = [&](std::size_t row, std::size_t field) {
    return features.triangles[row].stations.at(field);
  };
  layer.values.number = [](std::size_t, std::size_t) { return std::optional<double>(); };
  layer.shape = [&](std::size_t row) { return ogr_shape(shapes[row]); };
  layer.made_by = features.made_by;
  layer.prove = [&](const std::string& written, const std::string& driver) {
    const auto fault = fault_after_rounding(written, driver);
    if (!fault || fault->feature >= features.triangles.size()) return;
    const auto& [a, b, c] = features.triangles[fault->feature].stations;
    throw Error(Message{path, 0,
                        "the format rounds coordinates so that the triangle of stations " +
                            quoted(a, 80) + ", " + quoted(b, 80) + " and " + quoted(c, 80) +
                            " is no valid shape: " + fault->reason,
                        "a .gpkg keeps every digit"});
  };
  return write_vector_layer(layer, crs, path, older, warnings);
}

}  // namespace thiessen

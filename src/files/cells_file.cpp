#include "files/cells_file.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.h"
#include "files/cells_shapes.h"
#include "gdal/output/cells_layer.h"
#include "outlines/vertex_rounding.h"
#include "results/cells_geojson.h"

namespace thiessen {
namespace {

// Formats that can hold longitude and latitude and no other coordinates.
constexpr std::array<std::string_view, 3> degrees_only = {"kml", "kmz", "geojsonl"};

bool is_geojson(const std::string& extension) {
  return extension == "geojson" || extension == "json";
}

}  // namespace

std::string cells_geojson(const CellsOutput& output) {
  const std::optional<Crs> target = output.study_crs ? std::optional(Crs::wgs84()) : std::nullopt;
  const std::vector<MultiPolygon> shapes = cells_shapes(output, target);
  const VertexRounding rounding =
      target ? VertexRounding(shapes, decimals_for(output.tolerance)) : VertexRounding();
  return cells_geojson(output, shapes, rounding);
}

void require_cells_format(const std::string& path) {
  if (!is_geojson(extension_of(path))) require_cells_driver(path);
}

std::vector<EncodedFile> cells_files(const CellsOutput& output, const std::string& path) {
  const std::string extension = extension_of(path);
  if (is_geojson(extension)) return {{path, cells_geojson(output)}};
  require_cells_driver(path);
  std::optional<Crs> crs = output.file_crs ? output.file_crs : output.study_crs;
  if (std::find(degrees_only.begin(), degrees_only.end(), extension) != degrees_only.end()) {
    if (!output.study_crs) {
      throw Error(Message{
          path, 0, "the format holds longitude and latitude, and the coordinates' CRS is not known",
          "name it with " + setting("crs")});
    }
    crs = Crs::wgs84();
  }
  return write_cells_layer(output, cells_shapes(output, crs), crs, path);
}

}  // namespace thiessen

#include "gdal/output/isohyet_lines.h"

#include <cpl_string.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/interrupt.h"
#include "base/number.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"

namespace thiessen {
namespace {

constexpr const char* level_field = "level";

void require(bool done, const GdalErrors& errors) {
  if (done && !errors.failed()) return;
  throw Error(Message{"", 0, "GDAL cannot draw the isohyets: " + errors.text(), {}});
}

std::unique_ptr<GDALDataset> created(const char* driver, int columns, int rows, int bands) {
  GDALDriver* const found = GetGDALDriverManager()->GetDriverByName(driver);
  if (found == nullptr) return nullptr;
  return std::unique_ptr<GDALDataset>(
      found->Create("", columns, rows, bands, bands == 0 ? GDT_Unknown : GDT_Float32, nullptr));
}

std::unique_ptr<GDALDataset> raster_of(const PixelGrid& grid, std::span<const float> values,
                                       const GdalErrors& errors) {
  auto raster = created("MEM", grid.columns, grid.rows, 1);
  require(raster != nullptr, errors);
  const Point corner = grid.at(0, 0);
  double transform[6] = {corner.x, grid.pixel, 0, corner.y, 0, -grid.pixel};
  require(raster->SetGeoTransform(transform) == CE_None, errors);
  // GDAL only reads from the buffer, but its interface asks for one that may be written to.
  require(raster->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, grid.columns, grid.rows,
                                             const_cast<float*>(values.data()), grid.columns,
                                             grid.rows, GDT_Float32, 0, 0, nullptr) == CE_None,
          errors);
  return raster;
}

/// Draws all lines into a layer, and gives the dataset that holds it.
std::unique_ptr<GDALDataset> contours_of(GDALRasterBand& band, std::span<const double> levels,
                                         const GdalErrors& errors) {
  auto lines = created("Memory", 0, 0, 0);
  require(lines != nullptr, errors);
  OGRLayer* const layer = lines->CreateLayer("lines", nullptr, wkbLineString, nullptr);
  require(layer != nullptr, errors);
  OGRFieldDefn field(level_field, OFTReal);
  require(layer->CreateField(&field) == OGRERR_NONE, errors);
  std::string wanted;
  for (const double level : levels) wanted += (wanted.empty() ? "" : ",") + shortest_text(level);
  CPLStringList options;
  options.SetNameValue("FIXED_LEVELS", wanted.c_str());
  options.SetNameValue("ELEV_FIELD", "0");
  require(GDALContourGenerateEx(GDALRasterBand::ToHandle(&band), OGRLayer::ToHandle(layer),
                                options.List(), nullptr, nullptr) == CE_None,
          errors);
  return lines;
}

/// Appends the lines of a geometry; points, where a line only touches the basin, are none.
void append_lines(const OGRGeometry& geometry, std::vector<std::vector<Point>>& lines) {
  const auto type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbLineString) {
    auto& line = lines.emplace_back();
    for (const OGRPoint& p : *geometry.toLineString()) line.push_back({p.getX(), p.getY()});
  } else if (type == wkbMultiLineString || type == wkbGeometryCollection) {
    for (const OGRGeometry* const part : *geometry.toGeometryCollection())
      append_lines(*part, lines);
  }
}

/// Parallel to the levels, the lines within one basin.
std::vector<std::vector<std::vector<Point>>> within(OGRLayer& layer, const OGRGeometry& basin,
                                                    std::span<const double> levels) {
  std::vector<std::vector<std::vector<Point>>> lines(levels.size());
  for (const auto& feature : layer) {
    throw_if_interrupted();
    const OGRGeometry* const line = feature->GetGeometryRef();
    if (line == nullptr || !line->Intersects(&basin)) continue;
    const double level = feature->GetFieldAsDouble(0);
    const auto nearest = std::min_element(levels.begin(), levels.end(), [&](double a, double b) {
      return std::abs(a - level) < std::abs(b - level);
    });
    const std::unique_ptr<OGRGeometry> part(line->Intersection(&basin));
    if (part) append_lines(*part, lines[static_cast<std::size_t>(nearest - levels.begin())]);
  }
  return lines;
}

}  // namespace

std::vector<Isohyet> isohyets_of(const PixelGrid& grid, std::span<const float> values,
                                 std::span<const double> levels,
                                 std::span<const MultiPolygon> basins) {
  std::vector<Isohyet> isohyets;
  if (levels.empty()) return isohyets;
  start_gdal();
  GDALRegister_MEM();
  RegisterOGRMEM();
  const GdalErrors errors;
  const auto raster = raster_of(grid, values, errors);
  const auto contours = contours_of(*raster->GetRasterBand(1), levels, errors);
  for (std::size_t b = 0; b < basins.size(); ++b) {
    auto lines = within(*contours->GetLayer(0), *ogr_shape(basins[b]), levels);
    require(true, errors);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (!lines[i].empty()) isohyets.push_back({levels[i], b, std::move(lines[i])});
    }
  }
  return isohyets;
}

}  // namespace thiessen

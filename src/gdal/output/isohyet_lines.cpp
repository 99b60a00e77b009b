#include "gdal/output/isohyet_lines.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>

#include "base/interrupt.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"

namespace thiessen {
namespace {

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
                                 std::span<const MultiPolygon> basins, const Drawing& drawn) {
  std::vector<Isohyet> isohyets;
  if (levels.empty()) return isohyets;
  start_gdal();
  const GdalErrors errors;
  const auto contours = contours_of(grid, values, levels, drawn, errors);
  for (std::size_t b = 0; b < basins.size(); ++b) {
    auto lines = within(*contours->GetLayer(0), *ogr_shape(basins[b]), levels);
    require_drawn(true, drawn, errors);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (!lines[i].empty()) isohyets.push_back({levels[i], b, std::move(lines[i])});
    }
  }
  return isohyets;
}

}  // namespace thiessen

#include "gdal/output/surface_bands.h"

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/interrupt.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"
#include "gdal/output/contours.h"

namespace thiessen {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;

/// The shape of a contour, whose rings may touch themselves where GDAL closes them.
Geometry sound_shape(const OGRGeometry& contour) {
  return Geometry(contour.IsValid() ? contour.clone() : contour.MakeValid());
}

}  // namespace

MultiPolygon union_of(std::span<const MultiPolygon> shapes) {
  if (shapes.size() == 1) return shapes.front();
  start_gdal();
  const GdalErrors errors;
  OGRMultiPolygon all;
  for (const MultiPolygon& shape : shapes) {
    const auto parts = ogr_shape(shape);
    for (const OGRPolygon* const part : *parts) all.addGeometry(part);
  }
  const Geometry whole(all.UnionCascaded());
  require_contours(whole != nullptr, errors);
  return polygons_of(*whole);
}

std::vector<SurfaceBand> bands_of(const PixelGrid& grid, std::span<const float> values,
                                  std::span<const double> levels, const MultiPolygon& within,
                                  double longest) {
  double least = HUGE_VAL;
  double largest = -HUGE_VAL;
  for (const float value : values) {
    if (std::isnan(value)) continue;
    least = std::min<double>(least, value);
    largest = std::max<double>(largest, value);
  }
  if (least > largest) return {};
  std::vector<double> inside;
  for (const double level : levels) {
    if (level > least && level < largest) inside.push_back(level);
  }
  start_gdal();
  const GdalErrors errors;
  const auto area = ogr_shape(within);
  area->segmentize(longest);
  if (inside.empty()) return {{least, largest, polygons_of(*area)}};
  std::vector<SurfaceBand> bands;
  // GDAL leaves out what lies below the lowest level that it is given.
  inside.insert(inside.begin(), least - (largest - least));
  const auto contours = contours_of(grid, values, inside, ContourKind::areas, errors);
  for (const auto& feature : *contours->GetLayer(0)) {
    throw_if_interrupted();
    if (feature->GetGeometryRef() == nullptr) continue;
    const Geometry shape = sound_shape(*feature->GetGeometryRef());
    require_contours(shape != nullptr, errors);
    const Geometry part(shape->Intersection(area.get()));
    require_contours(part != nullptr, errors);
    if (part->IsEmpty()) continue;
    bands.push_back({std::max(least, feature->GetFieldAsDouble(0)),
                     std::min(largest, feature->GetFieldAsDouble(1)), polygons_of(*part)});
  }
  std::sort(bands.begin(), bands.end(),
            [](const SurfaceBand& a, const SurfaceBand& b) { return a.least < b.least; });
  return bands;
}

}  // namespace thiessen

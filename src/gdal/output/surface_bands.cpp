#include "gdal/output/surface_bands.h"

#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/interrupt.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"

namespace thiessen {
namespace {

using Geometry = std::unique_ptr<OGRGeometry>;

/// The shape of a band, whose edges rounding may have laid over each other.
Geometry sound_shape(const OGRGeometry& contour) {
  return Geometry(contour.IsValid() ? contour.clone() : contour.MakeValid());
}

}  // namespace

MultiPolygon union_of(std::span<const MultiPolygon> shapes, const Drawing& drawn) {
  if (shapes.size() == 1) return shapes.front();
  start_gdal();
  const GdalErrors errors;
  OGRMultiPolygon all;
  for (const MultiPolygon& shape : shapes) {
    const auto parts = ogr_shape(shape);
    for (const OGRPolygon* const part : *parts) all.addGeometry(part);
  }
  const Geometry whole(all.UnionCascaded());
  require_drawn(whole != nullptr, drawn, errors);
  return polygons_of(*whole);
}

std::vector<SurfaceBand> bands_of(const PixelValues& surface, std::span<const double> levels,
                                  const MultiPolygon& within, double longest,
                                  const Drawing& drawn) {
  double least = HUGE_VAL;
  double largest = -HUGE_VAL;
  for (const float value : surface.values) {
    if (std::isnan(value)) continue;
    least = std::min<double>(least, value);
    largest = std::max<double>(largest, value);
  }
  if (least > largest) return {};
  std::vector<double> ends{-HUGE_VAL};
  for (const double level : levels) {
    if (level > least && level < largest) ends.push_back(level);
  }
  ends.push_back(HUGE_VAL);
  start_gdal();
  const GdalErrors errors;
  const auto area = ogr_shape(within);
  area->segmentize(longest);
  if (ends.size() == 2 && surface.is_within.empty()) return {{least, largest, polygons_of(*area)}};
  std::vector<SurfaceBand> bands;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    throw_if_interrupted();
    const Geometry shape = sound_shape(*ogr_shape(ground_between(surface, ends[i - 1], ends[i])));
    require_drawn(shape != nullptr, drawn, errors);
    const Geometry part(shape->Intersection(area.get()));
    require_drawn(part != nullptr, drawn, errors);
    if (part->IsEmpty()) continue;
    bands.push_back({std::max(least, ends[i - 1]), std::min(largest, ends[i]), polygons_of(*part)});
  }
  return bands;
}

}  // namespace thiessen

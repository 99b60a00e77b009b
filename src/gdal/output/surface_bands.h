#pragma once

#include <span>
#include <vector>

#include "gdal/output/contours.h"
#include "geometry/polygon.h"
#include "rainfall/methods/value_bands.h"

namespace thiessen {

/// The ground on which a surface lies between two levels.
struct SurfaceBand {
  double least;
  double largest;
  MultiPolygon shape;
};

/// The union of shapes that may touch and overlap. Throws Error where GEOS fails,
/// with what was to be `drawn`.
MultiPolygon union_of(std::span<const MultiPolygon> shapes,
                      const Drawing& drawn = {"the surface", ""});

/// The ground between one level and the next of a raster's values (see ground_between), cut to a
/// shape in the raster's coordinates: by level. Where no level lies among the values, and the
/// surface has no end among the pixels, the whole shape is one band. No edge is longer than
/// `longest`, which is at least a pixel and a half, so that it may be taken to another projection.
/// Throws Error where GEOS fails, with what was to be `drawn`. Cost: the pixels and the shape's
/// vertices, times the levels.
std::vector<SurfaceBand> bands_of(const PixelValues& surface, std::span<const double> levels,
                                  const MultiPolygon& within, double longest,
                                  const Drawing& drawn = {"the surface", ""});

}  // namespace thiessen

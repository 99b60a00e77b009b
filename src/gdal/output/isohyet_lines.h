#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gdal/output/contours.h"
#include "geometry/pixel_grid.h"
#include "geometry/point.h"
#include "geometry/polygon.h"

namespace thiessen {

/// The isohyets of one level in one basin.
struct Isohyet {
  double level;
  std::size_t basin;                      ///< its position among the shapes
  std::vector<std::vector<Point>> lines;  ///< open, or closed by repeating the first point
};

/// The lines of equal value of a raster, linear between pixels' centres (GDAL's contour generator),
/// cut to the basins' shapes, which are in the raster's coordinates: by basin, then by level. No
/// line reaches into a pixel that is NaN. Throws Error where GDAL fails, with what was `drawn`.
std::vector<Isohyet> isohyets_of(const PixelGrid& grid, std::span<const float> values,
                                 std::span<const double> levels,
                                 std::span<const MultiPolygon> basins,
                                 const Drawing& drawn = {"the isohyets", ""});

}  // namespace thiessen

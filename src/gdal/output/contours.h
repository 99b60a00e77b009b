#pragma once

#include <memory>
#include <span>
#include <string>

#include "geometry/pixel_grid.h"

class GDALDataset;

namespace thiessen {

class GdalErrors;

/// What is drawn, as a message names it: "the isohyets". `path` is the file that they are for,
/// where the caller knows it.
struct Drawing {
  std::string noun;
  std::string path;
};

/// The contours of a raster as lines of one layer in memory, linear between pixels' centres. The
/// first field of a line is its level. No contour reaches into a pixel that is NaN. Throws Error
/// where GDAL fails, which `errors` tells, with what was to be drawn.
std::unique_ptr<GDALDataset> contours_of(const PixelGrid& grid, std::span<const float> values,
                                         std::span<const double> levels, const Drawing& drawn,
                                         const GdalErrors& errors);

/// Throws Error, with what was to be drawn, unless all is done and GDAL has told no error.
void require_drawn(bool done, const Drawing& drawn, const GdalErrors& errors);

}  // namespace thiessen

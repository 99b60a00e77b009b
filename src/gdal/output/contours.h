#pragma once

#include <memory>
#include <span>

#include "geometry/pixel_grid.h"

class GDALDataset;

namespace thiessen {

class GdalErrors;

/// The contours of a raster as lines of one layer in memory, linear between pixels' centres. The
/// first field of a line is its level. No contour reaches into a pixel that is NaN. Throws Error
/// where GDAL fails, which `errors` tells.
std::unique_ptr<GDALDataset> contours_of(const PixelGrid& grid, std::span<const float> values,
                                         std::span<const double> levels, const GdalErrors& errors);

/// Throws Error unless all is done and GDAL has told no error.
void require_contours(bool done, const GdalErrors& errors);

}  // namespace thiessen

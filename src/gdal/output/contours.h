#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "geometry/pixel_grid.h"

class GDALDataset;

namespace thiessen {

class GdalErrors;

/// What GDAL's contour generator makes of a raster: a line at each level, or the ground between one
/// level and the next.
enum class ContourKind : std::uint8_t { lines, areas };

/// The contours of a raster as features of one layer in memory, linear between pixels' centres. The
/// first field of a line is its level; the first two of an area are its least and largest value. No
/// contour reaches into a pixel that is NaN. Throws Error where GDAL fails, which `errors` tells.
std::unique_ptr<GDALDataset> contours_of(const PixelGrid& grid, std::span<const float> values,
                                         std::span<const double> levels, ContourKind kind,
                                         const GdalErrors& errors);

/// Throws Error unless all is done and GDAL has told no error.
void require_contours(bool done, const GdalErrors& errors);

}  // namespace thiessen

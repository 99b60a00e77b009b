#pragma once

#include <vector>

#include "basin/basin.h"
#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"

namespace thiessen {

/// The outline of an extent in the raster's coordinates, where its straight edges may be curves:
/// each is followed in a thousand steps, and points that have no place there are left out.
MultiPolygon mapped_extent(const MultiPolygon& extent, const PointMapping& to_raster);

/// The grid of pixels over the areas: their box, extended outward to multiples of the pixel's side.
/// The side is `resolution`, or where that is 0 a 2,000th of the longer side of the box. A box that
/// ends on a multiple is not extended there, whatever rounding does. Throws Error beyond 400
/// million pixels, or 100,000 on a side, or where the areas have no extent.
PixelGrid grid_over(const std::vector<MultiPolygon>& areas, double resolution);

}  // namespace thiessen

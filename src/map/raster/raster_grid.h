#pragma once

#include <vector>

#include "basin/basin.h"
#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"

namespace thiessen {

/// An extent's outline in the raster's coordinates, where its straight edges may be curves:
/// followed in a thousand steps each, without the points that have no place there.
MultiPolygon mapped_extent(const MultiPolygon& extent, const PointMapping& to_raster);

/// The pixels over the areas: their box, snapped outward to multiples of the pixel's side, which is
/// `resolution`, or 0 for the longer side in 2,000. A multiple stays, whatever rounding does.
/// Throws Error beyond 400 million pixels, or 100,000 on a side, or where the areas have no extent.
PixelGrid grid_over(const std::vector<MultiPolygon>& areas, double resolution);

}  // namespace thiessen

#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/polygon.h"
#include "rainfall/network.h"

namespace thiessen {

/// Takes points, a row's, from the raster's coordinates to the study's, in place; NaN where that
/// cannot be.
using ToStudy = std::function<void(std::vector<Point>&)>;

/// For each pixel, row by row from the north, the number (from 1, in file order) of the station
/// whose place is nearest to its centre, the lower number where several are as near, 0 outside the
/// areas. `areas`: in the raster's coordinates. `reports`: stations that take part, at least one.
/// `to_study` makes a transformation for one thread. Cost: linear in the pixels and the areas'
/// vertices.
std::vector<std::int32_t> owners(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                                 const Network& network, Metric metric,
                                 const std::vector<bool>& reports,
                                 const std::function<ToStudy()>& to_study, unsigned threads);

}  // namespace thiessen

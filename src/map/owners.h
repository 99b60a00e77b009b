#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/point_mapping.h"
#include "geometry/polygon.h"
#include "rainfall/network.h"

namespace thiessen {

/// For each pixel, row by row from the north, the number (from 1, in file order) of the station
/// whose place is nearest to its centre, the lower number where several are as near, 0 outside the
/// areas and where the projection ends. `areas`: in the raster's coordinates. `reports`: stations
/// that take part; without any all is 0. `to_study` makes a transformation for one thread.
/// Accuracy: see NearestPlaces::nearest. Cost: linear in the pixels, which are only filled, in
/// those along the cells' edges, and in the areas' vertices; n log n for n places. Memory: the
/// result's. Stops with Interrupted where a signal came.
std::vector<std::int32_t> owners(const PixelGrid& grid, const std::vector<MultiPolygon>& areas,
                                 const Network& network, Metric metric,
                                 const std::vector<bool>& reports,
                                 const std::function<PointMapping()>& to_study, unsigned threads);

}  // namespace thiessen

#pragma once

#include "gdal/crs/crs.h"
#include "geometry/point.h"

namespace thiessen {

/// Whether north is up, within 5 degrees, at a point of a CRS drawn with its x to the right and its
/// y upward. True of longitude and latitude, and where the point lies outside the CRS's area.
bool north_is_up(const Crs& crs, Point at);

}  // namespace thiessen

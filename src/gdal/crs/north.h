#pragma once

#include "gdal/crs/crs.h"
#include "geometry/box.h"

namespace thiessen {

/// Whether north is up on a map of this part of a CRS, drawn with its x to the right and its y
/// upward: within 5 degrees in its middle, and within 45 at its corners, so that a map with a pole
/// on it has none. True of longitude and latitude, and where the middle lies outside the CRS's
/// area.
bool north_is_up(const Crs& crs, const Box& map);

}  // namespace thiessen

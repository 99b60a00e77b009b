#pragma once

#include "base/error.h"
#include "files/basins_file.h"
#include "files/stations_file.h"

namespace thiessen {

/// Settles the CRS of both files: `basins` may be null.
/// 1. A GeoJSON without a `crs` member whose coordinates are mostly no longitudes and latitudes has
/// none.
/// 2. Beside x/y stations without a CRS a GeoJSON of basins without a `crs` member has none either.
/// 3. Where only one side names a CRS it holds for both, with a warning.
/// 4. Coordinates fit their CRS. Throws Error where they do not, naming CRS and range.
void agree_on_crs(StationsFile& stations, BasinsFile* basins, Warnings& warnings);

}  // namespace thiessen

#pragma once

#include "base/error.h"
#include "files/basins_file.h"
#include "files/stations_file.h"

namespace thiessen {

/// Settles the CRS of both files by these rules; `basins` may be null.
/// 1. A GeoJSON without a `crs` member has no CRS where most of its coordinates cannot be
/// longitudes and latitudes.
/// 2. Beside stations that have x and y and no CRS, basins in a GeoJSON without a `crs` member have
/// no CRS either.
/// 3. Where only one file names a CRS it holds for both, with a warning.
/// 4. Coordinates have to fit their CRS.
/// Throws Error where they do not fit, naming the CRS and the range of the coordinates.
void agree_on_crs(StationsFile& stations, BasinsFile* basins, Warnings& warnings);

}  // namespace thiessen

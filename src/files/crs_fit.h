#pragma once

#include "files/basins_file.h"
#include "files/stations_file.h"

namespace thiessen {

/// Requires the coordinates as a whole to fit the CRS of their file: metres do not fit degrees, nor
/// degrees a projection. Throws Error, naming the CRS and the range of the coordinates.
void require_fit(const StationsFile& stations);
void require_fit(const BasinsFile& basins);

}  // namespace thiessen

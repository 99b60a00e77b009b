#pragma once

#include "files/basins_file.h"
#include "files/stations_file.h"

namespace thiessen {

/// Coordinates that do not fit the file's CRS as a whole: metres under degrees, or degrees under a
/// projection. Throws Error, naming the CRS and the range.
void require_fit(const StationsFile& stations);
void require_fit(const BasinsFile& basins);

}  // namespace thiessen

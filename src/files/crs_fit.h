#pragma once

#include <string>

#include "files/basins_file.h"
#include "files/stations_file.h"

namespace thiessen {

/// Requires the coordinates to fit the CRS of their file, which has one: metres do not fit degrees,
/// nor degrees a projection, and longitudes and latitudes have their range. `lender` is the other
/// file, for messages, where the CRS was taken from that one. Throws Error, naming the CRS and the
/// range of the coordinates, or every station and basin that is out of range; the hint is a way
/// out.
void require_fit(const StationsFile& stations, const std::string& lender);
void require_fit(const BasinsFile& basins, const std::string& lender);

}  // namespace thiessen

#pragma once

#include <string>

#include "base/error.h"
#include "files/places/basins_file.h"
#include "files/places/stations_file.h"

namespace thiessen {

/// Requires the coordinates to fit the CRS of their file, which has one: metres do not fit degrees,
/// nor degrees a projection, and longitudes and latitudes have their range. `lender` is the other
/// file, for messages, where the CRS was taken from that one. Throws Error, naming the CRS and the
/// range of the coordinates, or every station and basin that is out of range; the hint is a way
/// out.
void require_fit(const StationsFile& stations, const std::string& lender);
void require_fit(const BasinsFile& basins, const std::string& lender);

/// Adds the coordinates that are out of the range of degrees to the faults of a file that could not
/// be read whole, so that it is mended once; nothing where there are no faults. Where it is not
/// sure that the coordinates are degrees, the files have to agree first.
void complain_of_range(const StationsFile& stations, Complaints& complaints);
void complain_of_range(const BasinsFile& basins, Complaints& complaints);

}  // namespace thiessen

#pragma once

#include "base/error.h"
#include "files/places/basins_file.h"
#include "files/places/stations_file.h"

namespace thiessen {

/// What the user asks of the coordinates of both files, beside naming their CRS.
enum class Asked {
  nothing,
  plane,  ///< distances in the coordinates as they are, which may have no CRS
  crs     ///< distances on the Earth or in another plane, for which a CRS is needed
};

/// Settles the CRS of both files by these rules; `basins` may be null.
///
/// - A GeoJSON without a `crs` member has no CRS where most of its coordinates cannot be longitudes
///   and latitudes. Where only some cannot, these are slips, and an error; but beside a file that
///   has no CRS (with a warning), and where a plane is asked for, the file is one of a plane.
/// - Where only one file has a CRS it holds for both, with a warning, whatever the format of
///   either.
/// - Coordinates have to fit their CRS: metres are not taken for degrees, nor degrees for metres.
/// - Where neither has a CRS and all coordinates could be degrees, a warning says that they are
///   taken as a plane, unless something is asked.
///
/// Throws Error where coordinates do not fit, naming the CRS and the range of the coordinates.
/// Cost: linear.
void agree_on_crs(StationsFile& stations, BasinsFile* basins, Asked asked, Warnings& warnings);

}  // namespace thiessen

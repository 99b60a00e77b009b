#pragma once

#include <optional>

#include "base/error.h"
#include "files/places/basins_file.h"
#include "files/places/stations_file.h"
#include "gdal/crs/crs.h"

namespace thiessen {

/// Chooses the operations by which the coordinates of both files come into `study`, the CRS of the
/// study. They are the best for the area of both files together, so that a place that is in both
/// files stays one place. `basins` may be null; `study` is nothing for a plane of its own. Warns
/// where the operation is known to be off by more than 5 m, with the figure, and where a sphere is
/// taken for WGS 84. Throws Error where no operation between the datums is known.
void settle_datums(StationsFile& stations, BasinsFile* basins, std::optional<Crs>& study,
                   Warnings& warnings);

}  // namespace thiessen

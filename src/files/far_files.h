#pragma once

#include <string>
#include <vector>

#include "gdal/crs/crs.h"
#include "study/coordinate_checks.h"
#include "study/far_cause.h"

namespace thiessen {

/// Words where the coordinates of a file are: `longitude 10 to 11, latitude 47 to 48 (EPSG:4326)`.
std::string extent_text(const Reach& reach, const Crs& crs);

/// The mistakes in files that may be why gauges and basins are nowhere near each other: in the
/// order, sign and unit of their coordinates, and in their CRSs (one in that of the other, another
/// zone of UTM). The corrections take points of `study`, the CRS of the study's coordinates.
std::vector<FarCause> far_causes_of_files(const Crs& stations, const Crs& basins, const Crs& study);

}  // namespace thiessen

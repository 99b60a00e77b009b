#pragma once

#include <optional>
#include <vector>

#include "files/study_files.h"
#include "geometry/point.h"

namespace thiessen {

/// The centroids of a study's basins, longitude and latitude on WGS 84 in degrees; nothing where
/// the plane of the study has no CRS, or its CRS does not reach so far.
std::optional<std::vector<Point>> centroids_on_earth(const StudyFiles& study);

/// The centroids of a study's basins in its own plane.
std::vector<Point> centroids_in_plane(const StudyFiles& study);

}  // namespace thiessen

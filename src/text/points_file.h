#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/point.h"

namespace thiessen {

/// The points of a CSV file, in its order: plain numbers in a plane or in space, without a CRS.
/// With a header, coordinates stand in the fields named x, lon, longitude or easting; y, lat,
/// latitude or northing; z, height, elevation or altitude; case is ignored, and other fields are
/// passed over. A first row of which any field is a number is no header: then the fields are the
/// coordinates and nothing else. -0 becomes 0. `file` may be `-`, the standard input.
///
/// Throws Error with every bad row (a coordinate that is no number, or outside the exact range of
/// predicates.h), where there are no points, and as CsvReader does. Warns of heights that the plane
/// passes over.
template <int Dimension>
std::vector<PositionIn<Dimension>> read_points(const std::string& file, Warnings& warnings);

}  // namespace thiessen

#pragma once

#include <string>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "geometry/point.h"

namespace thiessen {

/// Reads the points of a CSV file, in its order: plain numbers in a plane or in space, without a
/// CRS. `file` may be `-`, the standard input.
///
/// With a header, the coordinates are in the fields named x, lon, longitude or easting; y, lat,
/// latitude or northing; z, height, elevation or altitude. Case is ignored, and other fields are
/// skipped. A first row in which any field is a number is not a header: then the coordinates must
/// be the only fields. -0 becomes 0.
///
/// Throws Error with every bad row (a coordinate that is no number, or outside the exact range of
/// predicates.h), where there are no points, and as CsvReader does. Warns of heights that are
/// ignored in the plane.
template <int Dimension>
std::vector<PositionIn<Dimension>> read_points(const std::string& file, Warnings& warnings);
/// Reads the points of a file that is open.
template <int Dimension>
std::vector<PositionIn<Dimension>> read_points(InputFile file, Warnings& warnings);

}  // namespace thiessen

#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "geometry/polygon.h"
#include "io/basins_file.h"

namespace thiessen {

/// A basin's polygons as valid ones: outer rings counter-clockwise, holes clockwise, the last point
/// not repeated, rings touching in single points at most.
///
/// Valid polygons keep their vertices bit for bit. Repeated points, spikes, open rings, rings
/// without area and parts that share an edge are mended with a warning, and so is whatever has the
/// same area by even-odd and by winding number (shells counting as positive and holes as negative,
/// whatever direction they run in) to 1e-9 of it: the whole, the shells, the holes and each ring,
/// so that two faults cannot make up for each other. Any other crossing is added to `complaints`
/// with its place, and so is a basin without area; the answer is then nothing.
/// Cost: one check of validity (n log n); a mended basin some ten times that.
std::optional<MultiPolygon> mend(const RawBasin& basin, const std::string& file, Warnings& warnings,
                                 Complaints& complaints);

/// Longitudes (degrees) made to run on over the antimeridian: an edge that spans more than 180
/// degrees goes the short way, but one along a pole from -180 to 180 goes all round. Each polygon
/// is moved by whole turns so that its least longitude lies in
/// [-180, 180), and its holes with it. False where a ring winds round the Earth.
bool unwrap_longitudes(MultiPolygon& shape);

}  // namespace thiessen

#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "geometry/polygon.h"
#include "outlines/raw_basin.h"

namespace thiessen {

/// Makes a basin's polygons valid: outer rings counter-clockwise, holes clockwise, the last point
/// not repeated, rings touching in single points at most.
///
/// Valid polygons keep their vertices bit for bit. Repeated points, spikes, open rings, rings
/// without area and parts that share an edge are mended with a warning, and so is every fault that
/// leaves no more than 1e-9 of the area in dispute (see disputed_area). Crossings that leave up to
/// 1e-5 in dispute are mended too, each piece of ground counted once, with a warning that names the
/// first of them and the share. Any other crossing, and a basin without area, is added to
/// `complaints` with its place, and the result is empty. Cost: one check of validity (n log n);
/// some ten times that for a basin that is mended.
std::optional<MultiPolygon> mend(const RawBasin& basin, const std::string& file, Warnings& warnings,
                                 Complaints& complaints);

}  // namespace thiessen

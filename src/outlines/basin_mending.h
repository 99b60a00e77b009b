#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "geometry/polygon.h"
#include "outlines/raw_basin.h"

namespace thiessen {

/// A basin's polygons as valid ones: outer rings counter-clockwise, holes clockwise, the last point
/// not repeated, rings touching in single points at most.
///
/// Valid polygons keep their vertices bit for bit. Repeated points, spikes, open rings, rings
/// without area and parts that share an edge are mended with a warning, and so is whatever leaves
/// no more than 1e-9 of the area in dispute (see disputed_area). Crossings that leave up to 1e-5 in
/// dispute are mended too, each piece of ground counted once, with a warning that names the first
/// of them and the share. Any other crossing is added to `complaints` with its place, and so is a
/// basin without area; the answer is then nothing.
/// Cost: one check of validity (n log n); a mended basin some ten times that.
std::optional<MultiPolygon> mend(const RawBasin& basin, const std::string& file, Warnings& warnings,
                                 Complaints& complaints);

}  // namespace thiessen

#pragma once

#include <optional>
#include <string>

#include "base/error.h"
#include "geometry/polygon.h"
#include "outlines/mapping.h"
#include "outlines/raw_basin.h"

namespace thiessen {

/// How basins are mended, and what their coordinates are.
struct MendingRules {
  /// Whether shapes that cross themselves are mended by union, instead of refused.
  bool by_union = false;
  /// Whether longitudes run on over the antimeridian, so that areas are the ellipsoid's.
  bool round_the_earth = false;
  std::optional<CoordinateKind> kind;  ///< nothing where no CRS is known
};

/// Makes a basin's polygons valid: outer rings counter-clockwise, holes clockwise, the last point
/// not repeated, rings touching in single points at most.
///
/// Valid polygons keep their vertices bit for bit. Repeated points, spikes, open rings and rings
/// without area are mended with a warning, and so is every fault that leaves no more than 1e-9 of
/// the area in dispute (see ground_of): parts that share an edge, islands in lakes, parts that fill
/// a hole. Crossings that leave up to 1e-5 in dispute, and with `by_union` all of them, are mended
/// too, each piece of ground counted once, with a warning that names the place and the area in
/// dispute. Any other crossing, and a basin without area, is added to `complaints` with its place
/// and a hint, and the result is empty. Cost: one check of validity (n log n); some ten times that
/// for a basin that is mended.
std::optional<MultiPolygon> mend(const RawBasin& basin, const MendingRules& rules,
                                 const std::string& file, Warnings& warnings,
                                 Complaints& complaints);

}  // namespace thiessen

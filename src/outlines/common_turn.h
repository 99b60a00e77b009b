#pragma once

#include <span>

#include "outlines/antimeridian.h"

namespace thiessen {

/// Moves polygons by whole turns, so that the longitudes of all shapes lie within one turn of 360
/// degrees. The turn begins in the widest gap that no shape covers, so that shapes on both sides of
/// the antimeridian come together. If the shapes span no more as they are, they stay as they are,
/// bit for bit. Where shapes reach all round the Earth, those that cross the antimeridian are cut
/// there, into [-180, 180]. Requires polygons no wider than 360 degrees. Cost: n log n in the
/// polygons.
void bring_to_common_turn(std::span<CurvedShape* const> shapes);

}  // namespace thiessen

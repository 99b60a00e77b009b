#pragma once

#include <span>

#include "outlines/antimeridian.h"

namespace thiessen {

/// Moves polygons by whole turns, so that the longitudes of all shapes lie within one turn of 360
/// degrees that begins in the widest gap which none covers: what lies on both sides of the
/// antimeridian comes together. Shapes that already span no more than they would then stay as they
/// are, bit for bit. Where shapes reach all round the Earth, those that cross the antimeridian are
/// cut there, into [-180, 180]. Requires polygons no wider than 360 degrees. Cost: n log n in the
/// polygons.
void bring_to_common_turn(std::span<CurvedShape* const> shapes);

}  // namespace thiessen

#pragma once

#include <vector>

#include "base/error.h"
#include "basin/basin.h"
#include "study/source_lists.h"

namespace thiessen {

/// The shapes of the basins, mended (see mend), in their order; the list keeps ids and places, and
/// loses its polygons. `round_the_earth`: coordinates are longitudes and latitudes in degrees, and
/// edges go the short way over the antimeridian (see unwrap_longitudes). Throws Error with every
/// basin that has no area or crosses itself.
std::vector<MultiPolygon> mend_basins(BasinList& basins, bool round_the_earth, Warnings& warnings);

/// Brings basins in longitude and latitude that lie on both sides of the antimeridian together, so
/// that they are not far apart: see bring_to_common_turn.
void bring_basins_together(std::vector<Basin>& basins);
void bring_basins_together(std::vector<MultiPolygon>& shapes);

}  // namespace thiessen

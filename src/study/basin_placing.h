#pragma once

#include <vector>

#include "base/error.h"
#include "basin/basin.h"
#include "outlines/basin_mending.h"
#include "study/source_lists.h"

namespace thiessen {

/// Mends the polygons of the basins (see mend) and returns them, in the order of the list; the list
/// keeps ids and places, and loses its polygons. Where `rules.round_the_earth` is set, coordinates
/// are longitudes and latitudes in degrees, and edges take their way as unwrap_longitudes says;
/// what was assumed of wide edges is warned of, with the basin's area. Throws Error with every
/// basin that has no area, crosses itself, or has an edge whose way is not known. What is returned
/// and said is the same for any number of threads.
std::vector<MultiPolygon> mend_basins(BasinList& basins, const MendingRules& rules,
                                      Warnings& warnings, unsigned threads = 1);

/// Adds whole turns to the longitudes of basins in longitude and latitude that lie on both sides of
/// the antimeridian, so that they are not far apart: see bring_to_common_turn.
void bring_basins_together(std::vector<Basin>& basins);
void bring_basins_together(std::vector<MultiPolygon>& shapes);

}  // namespace thiessen

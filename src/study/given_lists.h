#pragma once

#include <vector>

#include "basin/basin.h"
#include "rainfall/network/network.h"
#include "study/source_lists.h"

namespace thiessen {

/// The gauges that a caller hands in, in the order given, once each is known to have an id of its
/// own and a place. Their list has no file and no lines. Throws Error with every fault: no station,
/// one without an id, an id given twice, a coordinate that is not finite.
StationList given_stations(std::vector<Station> stations);

/// The basins that a caller hands in, not yet mended; open rings are closed. Throws Error with
/// every fault: an id given twice, an empty geometry, a coordinate that is not finite.
BasinList given_basins(std::vector<Basin> basins);

}  // namespace thiessen

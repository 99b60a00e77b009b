#pragma once

#include <memory>

#include "readings/readings_reader.h"
#include "readings/stations/readings_stations.h"
#include "text/table.h"

namespace thiessen {

/// A wide table whose columns are called as stations with a unit of rain behind the id (`a (in)`,
/// `a_mm`), as one whose columns are called by the ids alone, with that as their unit (see
/// Table::unit). Any other table is passed on as it is, and so is a column whose name is an id as
/// it stands, or the id of another column without its unit.
///
/// Where neither the user nor a format says what the readings are in, all columns of stations must
/// have the same unit. Throws Error, where they have not, and as find_layout does.
std::unique_ptr<Table> with_units_in_names(std::unique_ptr<Table> table,
                                           const ReadingsStations& stations,
                                           const ReadingsOptions& options);

}  // namespace thiessen

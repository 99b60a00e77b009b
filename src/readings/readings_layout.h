#pragma once

#include <cstddef>

#include "readings/readings_reader.h"
#include "readings/readings_stations.h"
#include "text/table.h"

namespace thiessen {

/// Which columns of a table hold what; columns are numbered from 0.
struct ReadingsLayout {
  bool is_long = false;
  std::size_t time = 0;
  std::size_t station = 0;  ///< only of a long table
  std::size_t value = 0;    ///< only of a long table
};

/// Decides by the header whether a table is wide or long: see open_readings. Column names compare
/// without regard to case; that of the value may have a unit, as in prcp_mm or "Rain (in)". Throws
/// Error if a column that the user names is not there, or if the columns of a long table cannot be
/// found.
ReadingsLayout find_layout(const Table& table, const ReadingsStations& stations,
                           const ReadingsOptions& options);

}  // namespace thiessen

#pragma once

#include <cstddef>

#include "readings/readings_reader.h"
#include "readings/readings_stations.h"
#include "text/table.h"

namespace thiessen {

/// Which columns of a table hold what, from 0.
struct ReadingsLayout {
  bool is_long = false;
  std::size_t time = 0;
  std::size_t station = 0;  ///< of a long table, as the next
  std::size_t value = 0;
};

/// Decides by the header whether the table is wide or long: see open_readings. Names of columns
/// compare without case; the value's may bear a unit, as prcp_mm or "Rain (in)". Throws Error where
/// a column that is named is not there, or a long table's columns are not to be found.
ReadingsLayout find_layout(const Table& table, const ReadingsStations& stations,
                           const ReadingsOptions& options);

}  // namespace thiessen

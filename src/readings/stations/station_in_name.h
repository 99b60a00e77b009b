#pragma once

#include <memory>
#include <string>

#include "readings/stations/readings_stations.h"
#include "text/table.h"

namespace thiessen {

/// Whether a table names no station, neither in a column of stations nor in its header: it is then
/// of one station, which its file's name may tell.
bool names_no_station(const Table& table, const ReadingsStations& stations);

/// The id of the one station that the name of a file tells: the name without its extensions, or a
/// part of it between `_`, `-`, `.` and blanks (`rr_G44_2020.csv`); a part of a longer id does not
/// count. Empty where the name tells none. Throws Error where it tells several.
std::string station_in_name(const std::string& file, const ReadingsStations& stations);

/// What the column is called that of_station adds.
inline constexpr const char* station_of_name = "station";

/// The table with one column more, `station`, that holds this id in each row.
std::unique_ptr<Table> of_station(std::unique_ptr<Table> table, const std::string& id);

}  // namespace thiessen

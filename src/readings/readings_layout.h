#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/wording.h"
#include "readings/readings_reader.h"
#include "readings/stations/readings_stations.h"
#include "readings/times/time_columns.h"
#include "text/table.h"

namespace thiessen {

/// Which columns of a table hold what; columns are numbered from 0.
struct ReadingsLayout {
  bool is_long = false;
  TimeColumns time;
  std::size_t station = 0;                ///< only of a long table
  std::size_t value = 0;                  ///< only of a long table
  std::optional<std::size_t> index = {};  ///< of a wide table: a column that numbers its rows
  /// Of a wide table: the settings by which the time stands in further columns, where it seems to,
  /// and the user does not say in which it does; else empty.
  Wording time_meant = {};
};

/// Decides by the header whether a table is wide or long: see open_readings. Column names compare
/// without regard to case; that of the value may have a unit, as in prcp_mm or "Rain (in)". Where
/// no column of times is named, a column called date and one called time or hour are the time
/// together where the first row has a date and a clock in them, so are the columns of
/// time_in_parts, and the first column of a wide table is not the time if it has no name and
/// another is called time or the like. A column that is called as a station is none of the time.
/// Throws Error if a column that the user names is not there, or if the columns of a long table
/// cannot be found.
ReadingsLayout find_layout(const Table& table, const ReadingsStations& stations,
                           const ReadingsOptions& options);

/// Whether a header has columns of stations, of times and of values by their usual names, whatever
/// the stations are.
bool is_long_header(const std::vector<std::string>& header);

/// Whether a column is called as one of values is, such as prcp_mm.
bool is_called_as_values(std::string_view column);

/// The error that the time of a table is to be read from one column, and seems to stand in more;
/// `meant` names these.
Error time_in_more_columns(const Table& table, std::size_t column, const Wording& meant);

/// The columns of a long table, beside that of its values, that are called as one of values is.
std::vector<std::size_t> further_values(const Table& table, const ReadingsLayout& layout);

}  // namespace thiessen

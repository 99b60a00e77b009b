#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "rainfall/network.h"
#include "rainfall/series/readings.h"
#include "text/table.h"

namespace thiessen {

/// What the user says about RAINFALL. An empty field name means that the column is found by name.
struct ReadingsOptions {
  std::string time_field;
  std::string station_field;
  std::string value_field;
  std::vector<std::string> missing;  ///< further texts and numbers that mean "no reading"
  std::vector<std::string> trace;    ///< texts and numbers that mean 0
  bool decimal_comma = false;
  bool keep_flagged = false;    ///< of GHCN-Daily: readings that failed a check of quality count
  bool ignore_unknown = false;  ///< readings of unknown stations are passed over, with a warning
};

/// More than any gauge has caught in a year (26,470 mm): a reading above it is warned of.
constexpr double absurd_reading = 30'000;

/// The readings in a table, wide or long; `passed_over` are the ids that the user's filter left out
/// of the stations. The stations, the ids and `warnings` must outlive the result.
///
/// Wide: the first column (or `time_field`) is the time, each other column a station; read a row at
/// a time. Long: a station and a value column are found and neither header is a station's id, or
/// `station_field` or `value_field` is given. A long table in the order of time, ascending or
/// descending as text or with its numbers as numbers, is read a time after the other (a file; it is
/// looked through once before). Any other is sorted in some 100 MB of memory and temporary files
/// (see spool.h) of about 40 bytes a reading; its steps come in the order in which the times first
/// came. Memory does not grow with the number of steps.
///
/// Throws Error here for a header that cannot be read so, and for unknown stations of a wide table;
/// from `next` for the rest, in place of the steps that follow the first bad row or, of a long
/// table that is sorted, before the first step, but times given twice may be found only at the end.
/// All bad rows are reported together. Warnings come when the last step has been read: stations
/// without readings, unknown ones passed over, absurd readings.
std::unique_ptr<Readings> open_readings(std::unique_ptr<Table> table,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings);

}  // namespace thiessen

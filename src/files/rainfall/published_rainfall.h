#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/tables/source.h"
#include "readings/readings_reader.h"
#include "text/table.h"

namespace thiessen {

/// A table of readings, and what is known of it beside what the user says.
struct RainfallTable {
  std::unique_ptr<Table> table;
  ReadingsOptions options;
  bool is_of_one_station = false;               ///< and no column of it tells which
  std::vector<std::string> stations_told = {};  ///< what the file calls this, the first first
};

/// The error that a file of a known format holds no rain.
class NoRain : public Error {
 public:
  using Error::Error;
};

/// Opens RAINFALL as a table (see open_table), or that in an archive (see file_of_readings). A
/// published format (see PublishedFormat) is known by
/// its content, and what the file was taken for is told. Where the user names another column of
/// values than the format's own, nothing that is known of the format counts, with a warning.
/// `warnings` must outlive the result. Throws Error as open_table
/// and options_of do, NoRain, and Error where values with flags are to be kept of a format that has
/// none.
RainfallTable open_rainfall_table(const Source& rainfall, const ReadingsOptions& options,
                                  Warnings& warnings);

}  // namespace thiessen

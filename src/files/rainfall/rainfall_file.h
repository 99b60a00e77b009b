#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "files/tables/source.h"
#include "rainfall/network/reporting.h"
#include "readings/readings_reader.h"

namespace thiessen {

/// RAINFALL as the user names it.
struct RainfallRequest {
  std::vector<std::string> files;  ///< a folder stands for the files in it (see rainfall_files)
  Source said;                     ///< what is said of each of them; its own file counts nowhere
  std::vector<std::string> beside = {};  ///< the files of stations and basins: see rainfall_files

  /// What all of it is called in messages: `r.csv`, or `r.csv and 2 more files`.
  std::string name() const;
};

/// Opens RAINFALL: `.dly` files of GHCN-Daily (see open_dly_readings), or a table (see open_table),
/// whose readings are interpreted as open_readings says. Several files are joined in time and by
/// station (see JoinedReadings). A table of several that names no station is of the one that its
/// file's name tells (see station_in_name); one whose name tells none is passed over where unknown
/// stations are. Of several files those of a known format without rain are passed over with a
/// notice that names them, unless all are. Throws Error as these functions do. What is read of a
/// file of totals may be lacking: that is NoRain (see published_rainfall.h).
std::unique_ptr<Readings> open_rainfall(const RainfallRequest& rainfall,
                                        std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings);

/// Whether RAINFALL is one pipe or device, whose end may be far: the standard input where it is no
/// file.
bool is_fed(const RainfallRequest& rainfall);

/// Whether RAINFALL can be read more than once: the standard input, a pipe and a device cannot.
bool can_be_read_again(const RainfallRequest& rainfall);

/// The stations that have at least one reading in RAINFALL: see HeardStations. All of them where
/// there is a fault in it, which is met again, and told, when the readings are read; for that
/// RAINFALL has to be one that can be read again. Throws Interrupted.
ReportingStations stations_that_report(const RainfallRequest& rainfall,
                                       std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options);

}  // namespace thiessen

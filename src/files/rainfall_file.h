#pragma once

#include <memory>
#include <span>
#include <string>

#include "files/source.h"
#include "rainfall/network/reporting.h"
#include "readings/readings_reader.h"

namespace thiessen {

/// Opens RAINFALL as the user names it: `.dly` files of GHCN-Daily (see open_dly_readings), or a
/// table (see open_table), whose readings are interpreted as
/// open_readings says. Throws Error as these functions do.
std::unique_ptr<Readings> open_rainfall(const Source& rainfall, std::span<const Station> stations,
                                        std::span<const std::string> passed_over,
                                        const ReadingsOptions& options, Warnings& warnings);

/// Whether RAINFALL can be read more than once: the standard input, a pipe and a device cannot.
bool can_be_read_again(const std::string& rainfall);

/// The stations that have at least one reading in RAINFALL: see HeardStations. All of them where
/// there is a fault in it, which is met again, and told, when the readings are read; for that
/// RAINFALL has to be one that can be read again. Throws Interrupted.
ReportingStations stations_that_report(const Source& rainfall, std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options);

}  // namespace thiessen

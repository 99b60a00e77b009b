#pragma once

#include <memory>
#include <span>
#include <string>

#include "base/error.h"
#include "files/places/stations_file.h"
#include "rainfall/network/reporting.h"
#include "rainfall/series/readings.h"
#include "readings/readings_reader.h"

namespace thiessen {

/// What a step is called whose readings stand with the stations.
inline constexpr const char* event_time = "event";

/// Opens the readings of one event, which stand in the stations' file, in the field that
/// `options.value_field` names: one step, called event_time. `stations` are those of the study, and
/// `passed_over` those that are not of it. Fields are read as those of a long table: see
/// open_readings, also for what is thrown.
std::unique_ptr<Readings> open_event(const StationsRequest& request,
                                     std::span<const Station> stations,
                                     std::span<const std::string> passed_over,
                                     const ReadingsOptions& options, Warnings& warnings);

/// The stations that have a reading of the event: see stations_that_report.
ReportingStations stations_in_event(const StationsRequest& request,
                                    std::span<const Station> stations,
                                    std::span<const std::string> passed_over,
                                    const ReadingsOptions& options);

}  // namespace thiessen

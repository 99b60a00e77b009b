#pragma once

#include <span>
#include <string>

#include "files/rainfall/rainfall_file.h"
#include "rainfall/network/network.h"
#include "rainfall/network/reporting.h"
#include "readings/readings_reader.h"
#include "readings/totals/totals_source.h"

namespace thiessen {

/// Totals of gauges in files of any format of readings (see open_rainfall): the readings of their
/// steps and, where a column tells of how many days each is, the sums of several days; of
/// GHCN-Daily also its sums of several days (MDPR with DAPR). The stations and ids must outlive
/// what the source opens. Requires files that can be read again.
TotalsSource totals_in(const RainfallRequest& totals, std::span<const Station> stations,
                       std::span<const std::string> passed_over, const ReadingsOptions& options);

/// The stations that have at least one total: see stations_that_report.
ReportingStations stations_with_totals(const RainfallRequest& totals,
                                       std::span<const Station> stations,
                                       std::span<const std::string> passed_over,
                                       const ReadingsOptions& options);

}  // namespace thiessen

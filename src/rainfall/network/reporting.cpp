#include "rainfall/network/reporting.h"

#include <cmath>
#include <cstdint>

namespace thiessen {

ReportingStations reporting_stations(std::span<const double> readings) {
  ReportingStations report(readings.size(), false);
  for (std::uint32_t s = 0; s < readings.size(); ++s)
    report.set(StationIndex{s}, !std::isnan(readings[s]));
  return report;
}

ReportingPlaces reporting_places(const Network& network, std::span<const double> readings) {
  ReportingPlaces report(network.places().size(), false);
  for (std::uint32_t s = 0; s < readings.size(); ++s) {
    if (!std::isnan(readings[s])) report.set(network.place_of(StationIndex{s}), true);
  }
  return report;
}

}  // namespace thiessen

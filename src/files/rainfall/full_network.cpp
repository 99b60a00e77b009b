#include "files/rainfall/full_network.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "readings/stations/named_stations.h"

namespace thiessen {

void keep_full_network(StudyFiles& study, const ReportingStations& reports,
                       const std::string& rainfall, Warnings& warnings) {
  if (!reports.any()) {
    warnings.add_notice({rainfall, 0,
                         "no station has a reading: all " + std::to_string(study.stations.size()) +
                             " are taken for the network",
                         ""});
    return;
  }
  std::vector<std::vector<std::string>>& rows = study.attributes.rows;
  std::vector<std::string> first;
  std::size_t kept = 0;
  for (std::uint32_t s = 0; s < study.stations.size(); ++s) {
    if (!reports[StationIndex{s}]) {
      if (first.size() < stations_named) first.push_back(study.stations[s].id);
      study.never_reporting.push_back(std::move(study.stations[s]));
      continue;
    }
    if (kept != s) {
      study.stations[kept] = std::move(study.stations[s]);
      if (s < rows.size()) rows[kept] = std::move(rows[s]);
    }
    ++kept;
  }
  study.stations.resize(kept);
  if (rows.size() > kept) rows.resize(kept);
  if (study.never_reporting.empty()) return;
  warnings.add(
      {rainfall, 0,
       without_readings(first, study.never_reporting.size(), ", and no part in the network"), ""});
}

}  // namespace thiessen

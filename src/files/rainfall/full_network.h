#pragma once

#include <string>

#include "base/error.h"
#include "files/study_files.h"
#include "rainfall/network/reporting.h"

namespace thiessen {

/// Leaves in a study that has been read only the stations of its full network, those that report at
/// least once in RAINFALL, before anything is tessellated; so that weights, cells, values and
/// summaries are all of that one network. The others become StudyParts::never_reporting, and are
/// named in a warning of `rainfall`, the file of the readings. Where no station reports they all
/// stay, with a notice, for there is no other network to take. `reports` has one entry for each
/// station of the study. Cost: linear in the stations.
void keep_full_network(StudyFiles& study, const ReportingStations& reports,
                       const std::string& rainfall, Warnings& warnings);

}  // namespace thiessen

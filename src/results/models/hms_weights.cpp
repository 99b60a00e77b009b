#include "results/models/hms_weights.h"

#include <algorithm>

#include "base/number.h"
#include "base/utf8.h"

namespace thiessen {
namespace {

/// Whether a name stands alone on its line, from the first character to the last.
bool is_line(const std::string& name) {
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7F'; };
  return !name.empty() && trimmed(name) == name &&
         std::none_of(name.begin(), name.end(), is_control);
}

void check_names(const WeightsSubject& subject, const std::string& output,
                 const std::vector<bool>& weighs) {
  Complaints complaints;
  const auto check = [&](const char* what, const std::string& name, const char* set) {
    if (is_line(name)) return;
    complaints.add({output, 0,
                    std::string("the ") + what + "'s id " + quoted(name, 80) +
                        " cannot be a name in HEC-HMS: it is empty, or begins or ends with a "
                        "blank, or has control characters",
                    setting(set) + " names another field"});
  };
  for (const Basin& basin : subject.weighing.basins()) check("basin", basin.id, "basin_id");
  const std::vector<Station>& stations = subject.weighing.network().stations();
  for (std::size_t s = 0; s < stations.size(); ++s) {
    if (weighs[s]) check("station", stations[s].id, "id");
  }
  complaints.throw_if_any();
}

std::vector<bool> gages_of(const WeightsSubject& subject) {
  std::vector<bool> weighs(subject.weighing.network().stations().size(), false);
  for (const BasinWeights& basin : subject.weights) {
    for (const StationWeight& part : basin.stations) weighs[index(part.station)] = true;
  }
  return weighs;
}

}  // namespace

void HmsWeights::write(OutputFile& file, const WeightsSubject& subject,
                       Warnings& /*warnings*/) const {
  const std::vector<bool> weighs = gages_of(subject);
  check_names(subject, file.name(), weighs);
  const std::vector<Station>& stations = subject.weighing.network().stations();
  file.append("Meteorology: Thiessen weights\n     Description: " + sentence_of(subject.made_by) +
              "\n     Version: 4.0\n     Unit System: Metric\n"
              "     Precipitation Method: Weighted Gages\n"
              "     Evapotranspiration Method: No Evapotranspiration\n"
              "     Snowmelt Method: None\nEnd:\n\n"
              "Precip Method Parameters: Weighted Gages\n     Use HEC1 Weighting Scheme: No\n"
              "     Use Indexing: No\n     Allow Depth Override: No\nEnd:\n\n");
  for (std::size_t s = 0; s < stations.size(); ++s) {
    if (weighs[s]) file.append("Gage: " + stations[s].id + "\n     Type: Recording\nEnd:\n\n");
  }
  for (std::size_t b = 0; b < subject.weights.size(); ++b) {
    std::string block = "Subbasin: " + subject.weighing.basins()[b].id + '\n';
    for (const StationWeight& part : subject.weights[b].stations) {
      const std::string weight = shortest_text(part.weight);
      block += "     Gage: " + stations[index(part.station)].id +
               "\n     Volume Weight: " + weight +
               "\n     Temporal Distribution Weight: " + weight + '\n';
    }
    file.append(block + "End:\n\n");
  }
}

}  // namespace thiessen

#include "files/normals/field_study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/number.h"
#include "base/utf8.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

using ById = std::unordered_map<std::string, std::vector<double>>;

/// What is wrong with normals; empty where nothing is.
std::string fault_of(const std::vector<double>& normals, const std::string& field) {
  for (std::size_t m = 0; m < normals.size(); ++m) {
    if (std::isfinite(normals[m]) && normals[m] > 0) continue;
    const std::string month = std::to_string(m + 1);
    const std::string name =
        quoted(normals.size() == 1 ? field : field + (m < 9 ? "_0" : "_") + month, 80);
    if (std::isnan(normals[m])) return "has no normal in " + name;
    return "has the normal " + shortest_text(normals[m]) + " in " + name +
           ", and normals are above 0";
  }
  return {};
}

}  // namespace

std::shared_ptr<const NormalField> normals_of_fields(const std::string& field, const Study& study,
                                                     const StudyFiles& files) {
  Complaints complaints;
  const auto of = [&](const ById& all, const std::string& id, const std::string& what,
                      const Message& where) {
    const auto found = all.find(id);
    const std::string fault = found == all.end() ? "has no normal" : fault_of(found->second, field);
    if (!fault.empty())
      complaints.add(
          {where.file, where.line, what + " " + quoted(id, 80) + " " + fault, where.hint});
    return found == all.end() ? std::vector<double>() : found->second;
  };
  std::vector<std::vector<double>> gauges;
  const std::vector<Station>& stations = study.network().stations();
  for (std::size_t s = 0; s < stations.size(); ++s) {
    const bool is_opened = s + files.opened >= stations.size();
    const std::size_t line = files.stations_have_lines && !is_opened ? stations[s].line : 0;
    gauges.push_back(
        of(files.station_normals, stations[s].id, "station",
           {is_opened ? files.opened_from : files.stations_file, line, "",
            is_opened ? setting("normals") + " has normals at any place"
                      : setting("stations_where") + " leaves stations out of the network"}));
  }
  std::vector<std::vector<double>> basins;
  for (const Basin& basin : study.basins()) {
    basins.push_back(
        of(files.basin_normals, basin.id, "basin",
           {files.basins_file, 0, "", setting("basins_where") + " leaves basins out"}));
  }
  complaints.throw_if_any();
  if (gauges.front().size() != basins.front().size()) {
    throw Error({gauges.front().size() == 1 ? files.stations_file : files.basins_file, 0,
                 "has one field " + quoted(field, 80) + ", and " +
                     (gauges.front().size() == 1 ? files.basins_file : files.stations_file) +
                     " has twelve, of calendar months",
                 "both have one, or both have twelve"});
  }
  return std::make_shared<const UniformNormals>(std::move(gauges), basins);
}

}  // namespace thiessen

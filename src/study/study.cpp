#include "study/study.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/enumeration.h"
#include "geometry/exact_range.h"
#include "geometry/predicates.h"
#include "geometry/shape_points.h"
#include "rainfall/network/extent.h"
#include "study/lost_digits.h"
#include "study/nearness.h"

namespace thiessen {
namespace {

constexpr std::size_t named_at_most = 5;

std::string place_text(const StudyParts& parts, const Station& station) {
  const bool has_line = parts.stations_have_lines || station.line == 0;
  return "station '" + station.id + "'" +
         (has_line ? "" : " (feature " + std::to_string(station.line) + ")");
}

Yardstick yardstick_of(const StudyParts& parts, double tolerance) {
  const double unit = parts.metres_per_unit.value_or(1);
  return {parts.metric, unit * unit, tolerance};
}

/// Moves the stations out of the parts once all coordinates are known to lie in the exact range.
std::vector<Station> in_exact_range(StudyParts& parts) {
  Complaints complaints;
  const std::string range(outside_exact_range);
  for (std::size_t i = 0; i < parts.stations.size(); ++i) {
    const Station& station = parts.stations[i];
    if (in_exact_range(station.position)) continue;
    const bool is_opened = i + parts.opened >= parts.stations.size();
    complaints.add({is_opened ? parts.opened_from : parts.stations_file,
                    parts.stations_have_lines ? station.line : 0,
                    "a coordinate of " + place_text(parts, station) + " is " + range, ""});
  }
  for (const Basin& basin : parts.basins) {
    if (every_point(basin.shape, [](Point p) { return in_exact_range(p); })) continue;
    complaints.add(
        {parts.basins_file, 0, "a coordinate of basin '" + basin.id + "' is " + range, ""});
  }
  complaints.throw_if_any();
  return std::move(parts.stations);
}

const std::vector<Basin>& basins_or_extent(StudyParts& parts, const Network& network,
                                           double margin) {
  if (parts.has_basins) return parts.basins;
  auto area = extent_of(network.places(), parts.metric, margin);
  if (!area) {
    throw Error({parts.stations_file, 0, "the stations have no extent to make a study area of",
                 "give " + input("basins") + ", or a " + setting("margin") +
                     " above 0 where they lie on one line"});
  }
  parts.basins.push_back(std::move(*area));
  return parts.basins;
}

const std::vector<Basin>& drawn_basins(const StudyParts& parts) {
  return parts.drawn_basins.empty() ? parts.basins : parts.drawn_basins;
}

}  // namespace

Study::Study(std::shared_ptr<StudyParts> parts, const StudySettings& settings, Warnings& warnings)
    : parts_(std::move(parts)),
      network_(in_exact_range(*parts_), parts_->metric),
      weighing_(network_, basins_or_extent(*parts_, network_, settings.margin),
                drawn_basins(*parts_), yardstick_of(*parts_, settings.tolerance)) {
  judge_digits(*parts_, warnings);
  warn_of_shared_places(warnings);
  warn_of_line(warnings);
  if (parts_->has_basins) judge_nearness(*parts_, network_, settings.allow_far, warnings);
}

std::vector<NearestGauge> Study::nearest_gauges() const {
  if (!parts_->has_basins) return {};
  return thiessen::nearest_gauges(network_.places(), parts_->basins, Ruler(*parts_));
}

void Study::warn_of_shared_places(Warnings& warnings) const {
  std::size_t shared = 0;
  for (std::uint32_t p = 0; p < network_.places().size(); ++p) {
    std::vector<StationIndex> stations;  // a gauge that a what-if opens is not in the file yet
    for (const StationIndex s : network_.stations_at(PlaceIndex{p})) {
      if (index(s) + parts_->opened < network_.stations().size()) stations.push_back(s);
    }
    if (stations.size() < 2 || ++shared > named_at_most) continue;
    std::vector<std::string> ids;
    ids.reserve(stations.size());
    for (const StationIndex s : stations) ids.push_back(network_.stations()[index(s)].id);
    warnings.add(
        {parts_->stations_file, 0,
         "stations " + names_up_to(named_at_most, ids) + " stand at one place and share its cell",
         ""});
  }
  if (shared > named_at_most) {
    warnings.add({parts_->stations_file, 0,
                  std::to_string(shared - named_at_most) + " more places have several stations",
                  ""});
  }
}

void Study::warn_of_line(Warnings& warnings) const {
  const std::vector<Point>& places = network_.places();
  if (parts_->metric != Metric::planar || places.size() < 3) return;
  const bool on_line = std::all_of(places.begin() + 2, places.end(), [&](Point p) {
    return orientation(places[0], places[1], p) == 0;
  });
  if (on_line)
    warnings.add(
        {parts_->stations_file, 0, "the stations lie on one line: their cells are strips", ""});
}

}  // namespace thiessen

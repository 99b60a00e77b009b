#include "cli/session.h"

#include "files/rainfall_file.h"

#include <algorithm>

#include "geometry/exact_range.h"
#include "geometry/predicates.h"
#include "rainfall/extent.h"
#include "rainfall/series/watched_readings.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t named_at_most = 5;

std::string place_text(const Study& study, const Station& station) {
  const bool has_line = study.stations_have_lines || station.line == 0;
  return "station '" + station.id + "'" +
         (has_line ? "" : " (feature " + std::to_string(station.line) + ")");
}

Ground ground_of(const Study& study, double tolerance) {
  const double unit = study.metres_per_unit.value_or(1);
  return {study.metric, unit * unit, tolerance};
}

}  // namespace

Session::Session(const StudyOptions& options, double margin, Warnings& warnings)
    : study_(read_study(options.request(), warnings)), has_basins_(!study_.basins_file.empty()) {
  filtered_ids_.assign(study_.filtered_ids.begin(), study_.filtered_ids.end());
  check_range();
  network_ = std::make_unique<Network>(study_.stations, study_.metric);
  if (!has_basins_) add_extent_as_basin(margin);
  warn_of_shared_places(warnings);
  warn_of_line(warnings);
  weighing_ =
      std::make_unique<Weighing>(*network_, study_.basins, ground_of(study_, options.tolerance()));
}

AreaUnit Session::area_unit() const {
  const bool known = study_.metric == Metric::geodesic || study_.metres_per_unit.has_value();
  return {known ? 1e-6 : 1.0};
}

std::unique_ptr<WatchedReadings> Session::open_readings(const StudyOptions& study,
                                                        const RainfallOptions& rainfall,
                                                        Warnings& warnings,
                                                        const std::optional<StepTimes>& wanted) {
  auto readings = open_rainfall(rainfall.rainfall, study.separator(), network_->stations(),
                                filtered_ids_, rainfall.readings(study.decimal_comma()), warnings);
  if (wanted) {
    readings =
        std::make_unique<DatedReadings>(std::move(readings), rainfall.name(), *wanted, warnings);
  }
  return std::make_unique<WatchedReadings>(std::move(readings));
}

void Session::add_extent_as_basin(double margin) {
  auto area = extent_of(network_->places(), study_.metric, margin);
  if (!area) {
    throw Error({study_.stations_file, 0, "the stations have no extent to make a study area of",
                 "give BASINS, or a --margin above 0 where they lie on one line"});
  }
  study_.basins.push_back(std::move(*area));
}

void Session::check_range() const {
  Complaints complaints;
  const std::string range(outside_exact_range);
  for (const Station& station : study_.stations) {
    if (in_exact_range(station.position)) continue;
    complaints.add({station.line == 0 ? "--with" : study_.stations_file,
                    study_.stations_have_lines ? station.line : 0,
                    "a coordinate of " + place_text(study_, station) + " is " + range, ""});
  }
  for (const Basin& basin : study_.basins) {
    const auto is_bad = [](const Ring& ring) {
      return std::any_of(ring.begin(), ring.end(), [](Point p) { return !in_exact_range(p); });
    };
    const bool bad = std::any_of(basin.shape.begin(), basin.shape.end(), [&](const Polygon& part) {
      return is_bad(part.outer) || std::any_of(part.holes.begin(), part.holes.end(), is_bad);
    });
    if (bad)
      complaints.add(
          {study_.basins_file, 0, "a coordinate of basin '" + basin.id + "' is " + range, ""});
  }
  complaints.throw_if_any();
}

void Session::warn_of_shared_places(Warnings& warnings) const {
  std::size_t shared = 0;
  for (std::uint32_t p = 0; p < network_->places().size(); ++p) {
    std::vector<StationIndex> stations;  // of the file: what is opened is not there yet
    for (const StationIndex s : network_->stations_at(PlaceIndex{p})) {
      if (index(s) + study_.opened < network_->stations().size()) stations.push_back(s);
    }
    if (stations.size() < 2 || ++shared > named_at_most) continue;
    std::string ids;
    for (std::size_t i = 0; i < std::min(stations.size(), named_at_most); ++i) {
      ids += (i == 0 ? "'" : ", '") + network_->stations()[index(stations[i])].id + "'";
    }
    if (stations.size() > named_at_most)
      ids += " and " + std::to_string(stations.size() - named_at_most) + " more";
    warnings.add({study_.stations_file, 0,
                  "stations " + ids + " stand at one place and share its cell", ""});
  }
  if (shared > named_at_most) {
    warnings.add({study_.stations_file, 0,
                  std::to_string(shared - named_at_most) + " more places have several stations",
                  ""});
  }
}

void Session::warn_of_line(Warnings& warnings) const {
  const std::vector<Point>& places = network_->places();
  if (study_.metric != Metric::planar || places.size() < 3) return;
  const bool on_line = std::all_of(places.begin() + 2, places.end(), [&](Point p) {
    return orientation(places[0], places[1], p) == 0;
  });
  if (on_line)
    warnings.add(
        {study_.stations_file, 0, "the stations lie on one line: their cells are strips", ""});
}

}  // namespace thiessen::cli

#include "files/normals/gauge_elevations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "base/utf8.h"
#include "rainfall/normals/elevation_units.h"
#include "text/field_names.h"
#include "text/known_names.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// How many metres the raster's unit is, by its name; nothing where that is metres or unknown.
std::optional<double> feet_of(const RasterSource& source) {
  constexpr std::array<std::string_view, 4> feet = {"ft", "feet", "foot", "international foot"};
  constexpr std::array<std::string_view, 4> survey_feet = {"us survey foot", "us survey feet",
                                                           "us-ft", "ftus"};
  const std::string unit = source.unit();
  const auto is_one_of = [&](const auto& names) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return same_name(unit, name); });
  };
  if (is_one_of(feet)) return metres_in_foot;
  constexpr double metres_in_survey_foot = 1200.0 / 3937;
  if (is_one_of(survey_feet)) return metres_in_survey_foot;
  return std::nullopt;
}

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

/// The elevations of the stations' field, by station.
std::vector<double> of_field(const Study& study, const StudyFiles& files) {
  std::vector<double> elevations;
  for (const Station& station : study.network().stations()) {
    const auto found = files.station_elevations.find(station.id);
    elevations.push_back(found == files.station_elevations.end() ? none : found->second);
  }
  return elevations;
}

std::vector<double> of_pixels(const RasterGround& ground) {
  if (ground.source().bands() != 1) {
    throw Error({ground.source().file(), 0,
                 "has " + std::to_string(ground.source().bands()) +
                     " bands, and a raster of elevations has one",
                 "gdal_translate -b N makes a raster of one"});
  }
  std::vector<double> elevations;
  for (const std::vector<double>& bands : ground.at_stations()) elevations.push_back(bands.front());
  return elevations;
}

/// Settles the unit of the raster's elevations, which become those of the ground.
double settle_unit(const std::vector<double>& stations, std::vector<double>& pixels,
                   const StudyFiles& files, const RasterSource& source, Warnings& warnings) {
  const std::optional<double> feet = feet_of(source);
  if (feet && judge_feet(stations, pixels) == InFeet::nobody &&
      judge_feet(stations, scaled(pixels, *feet)) == InFeet::stations) {
    warnings.add_notice({source.file(), 0,
                         "its elevations are in feet, as are those of " + files.stations_file, ""});
    return 1;
  }
  const double scale = feet.value_or(1);
  if (feet) {
    pixels = scaled(pixels, scale);
    warnings.add_notice({source.file(), 0, "its elevations are brought from feet to metres", ""});
  }
  switch (judge_feet(stations, pixels)) {
    case InFeet::nobody:
      return scale;
    case InFeet::stations:
      throw Error({files.stations_file, 0,
                   "the elevations in " + quoted(files.elevation_field, 80) +
                       " are 3.28 times those of " + source.file() +
                       ": they are in feet, and the raster's in metres",
                   setting("elevation_field") + " names a field in metres"});
    case InFeet::raster:
      throw Error({source.file(), 0,
                   "its elevations are 3.28 times those in " + quoted(files.elevation_field, 80) +
                       " of " + files.stations_file +
                       ": they are in feet, and the stations' in metres",
                   "gdal_translate -of VRT -a_scale 0.3048 makes metres of feet"});
  }
  return scale;
}

/// Some ids for a message.
std::string some_of(const std::vector<std::string>& ids) {
  return (ids.size() == 1 ? "station " : std::to_string(ids.size()) + " stations: ") + listed(ids);
}

/// Takes from the raster what the field lacks, and says so.
void take_pixels(std::vector<double>& elevations, const std::vector<double>& pixels,
                 const Study& study, const StudyFiles& files, const RasterSource& source,
                 Warnings& warnings) {
  std::vector<std::string> taken;
  for (std::size_t s = 0; s < elevations.size(); ++s) {
    if (!std::isnan(elevations[s]) || std::isnan(pixels[s])) continue;
    elevations[s] = pixels[s];
    taken.push_back(study.network().stations()[s].id);
  }
  if (taken.empty()) return;
  const std::string here = "the elevation of its pixel there is that of ";
  if (files.elevation_field.empty()) {
    warnings.add_notice({source.file(), 0,
                         here + "each station, for " + files.stations_file +
                             " has no field of them (" + listed(known::elevations) + ")",
                         ""});
  } else {
    warnings.add_notice({source.file(), 0,
                         here + some_of(taken) + ", for " + quoted(files.elevation_field, 80) +
                             " of " + files.stations_file + " is empty",
                         ""});
  }
}

void require_all(const std::vector<double>& elevations, const Study& study, const StudyFiles& files,
                 const RasterGround* ground) {
  Complaints complaints;
  const std::vector<Station>& stations = study.network().stations();
  for (std::size_t s = 0; s < stations.size(); ++s) {
    if (!std::isnan(elevations[s])) continue;
    const bool is_opened = s + files.opened >= stations.size();
    const std::string in_field =
        files.elevation_field.empty() ? std::string() : " in " + quoted(files.elevation_field, 80);
    complaints.add(
        {is_opened ? files.opened_from : files.stations_file,
         files.stations_have_lines && !is_opened ? stations[s].line : 0,
         "station " + quoted(stations[s].id, 80) + " has no elevation" +
             (is_opened ? "" : in_field) +
             (ground == nullptr ? std::string()
                                : ", and " + ground->source().file() + " has none where it stands"),
         ground == nullptr ? setting("elevation") + " has the ground's at any place"
                           : setting("stations_where") + " leaves stations out of the network"});
  }
  complaints.throw_if_any();
}

/// Gives all stations at one place the mean of what is known.
void join_places(std::vector<double>& elevations, const Network& network) {
  for (std::uint32_t p = 0; p < network.places().size(); ++p) {
    const auto stations = network.stations_at(PlaceIndex{p});
    if (stations.size() == 1) continue;
    double sum = 0;
    double count = 0;
    for (const StationIndex s : stations) {
      if (std::isnan(elevations[index(s)])) continue;
      sum += elevations[index(s)];
      ++count;
    }
    for (const StationIndex s : stations) elevations[index(s)] = count > 0 ? sum / count : none;
  }
}

}  // namespace

GaugeElevations elevations_of_gauges(const Study& study, const StudyFiles& files,
                                     const RasterGround* ground, bool is_field_named,
                                     Warnings& warnings) {
  GaugeElevations found;
  found.of_stations = of_field(study, files);
  if (!files.elevation_field.empty() && !is_field_named) {
    warnings.add_notice(
        {files.stations_file, 0,
         "elevations of stations are those of its field " + quoted(files.elevation_field, 80), ""});
  }
  std::vector<double> pixels;
  if (ground != nullptr) {
    pixels = of_pixels(*ground);
    found.raster_scale = settle_unit(found.of_stations, pixels, files, ground->source(), warnings);
  }
  join_places(found.of_stations, study.network());
  if (ground != nullptr)
    take_pixels(found.of_stations, pixels, study, files, ground->source(), warnings);
  join_places(found.of_stations, study.network());
  require_all(found.of_stations, study, files, ground);
  return found;
}

}  // namespace thiessen

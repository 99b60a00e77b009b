#include "study/thiessen.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_set>
#include <utility>

#include "base/utf8.h"
#include "geometry/shape_points.h"
#include "rainfall/areal_rainfall.h"
#include "study/basin_placing.h"
#include "study/coordinate_checks.h"
#include "study/study.h"

namespace thiessen {
namespace {

constexpr std::size_t longest_id = 80;
constexpr CoordinateKind degrees{true, 1};

std::string named(const Station& station) {
  return "station " + quoted(station.id, longest_id);
}

/// Returns the gauges in the order given, once each is known to have an id of its own and a place.
StationList checked(std::vector<Station> stations) {
  Complaints complaints;
  if (stations.empty()) complaints.add({"", 0, "there are no stations", ""});
  std::unordered_set<std::string> ids;
  for (Station& station : stations) {
    if (station.id.empty()) complaints.add({"", 0, "a station has no id", ""});
    if (!station.id.empty() && !ids.insert(station.id).second)
      complaints.add({"", 0, named(station) + " is there twice", "ids must differ"});
    if (!is_finite(station.position))
      complaints.add({"", 0, named(station) + " has a coordinate that is not finite", ""});
    // Adding zero turns -0 into 0, so that both are the same place.
    station.position = {station.position.x + 0.0, station.position.y + 0.0};
    station.line = 0;
  }
  complaints.throw_if_any();
  return {"", std::move(stations), false};
}

/// Repeats the first point of a ring as its last, as rings in a file have it: an open ring would be
/// reported as a fault.
void close(Ring& ring) {
  if (!ring.empty() && ring.front() != ring.back()) ring.push_back(ring.front());
}

BasinList checked(std::vector<Basin> basins) {
  BasinList list;
  Complaints complaints;
  std::unordered_set<std::string> ids;
  for (Basin& basin : basins) {
    const std::string place = "basin " + quoted(basin.id, longest_id);
    if (!ids.insert(basin.id).second)
      complaints.add(
          {"", 0, place + " is there twice", "parts of one basin are one basin's shape"});
    if (basin.shape.empty()) complaints.add({"", 0, place + " has an empty geometry", ""});
    if (!every_point(basin.shape, is_finite))
      complaints.add({"", 0, place + " has a coordinate that is not finite", ""});
    for (Polygon& polygon : basin.shape) {
      close(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), close);
    }
    list.basins.push_back({std::move(basin.id), place, 0, std::move(basin.shape)});
  }
  complaints.throw_if_any();
  return list;
}

void check_settings(const ThiessenInput& input) {
  Complaints complaints;
  const auto check = [&](bool good, const char* text) {
    if (!good) complaints.add({"", 0, text, ""});
  };
  check(plane_units.holds(input.metres_per_unit),
        "the length of the plane's unit is not between 1e-9 and 1e9 metres");
  check(tolerances.holds(input.tolerance), "the tolerance is not between 0.001 and 1e6 metres");
  check(margins.holds(input.margin), "the margin is not between 0 and 1000 percent");
  complaints.throw_if_any();
}

std::shared_ptr<StudyParts> parts_of(ThiessenInput input, Warnings& warnings) {
  check_settings(input);
  const bool on_earth = input.metric == Metric::geodesic;
  StationList stations = checked(std::move(input.stations));
  BasinList basins = checked(std::move(input.basins));
  if (on_earth) {
    require_degrees(stations, degrees);
    require_degrees(basins, degrees);
    turn_longitudes(stations, degrees, warnings);
  }
  auto parts = std::make_shared<StudyParts>();
  parts->metric = input.metric;
  parts->stations = std::move(stations.stations);
  parts->has_basins = !basins.basins.empty();
  if (!on_earth) parts->metres_per_unit = input.metres_per_unit;
  const CoordinateKind kind = on_earth ? degrees : CoordinateKind{false, input.metres_per_unit};
  std::vector<MultiPolygon> shapes = mend_basins(basins, {input.mend, on_earth, kind}, warnings);
  for (std::size_t i = 0; i < shapes.size(); ++i)
    parts->basins.push_back({std::move(basins.basins[i].id), std::move(shapes[i]), {}});
  if (on_earth) bring_basins_together(parts->basins);
  return parts;
}

}  // namespace

struct Thiessen::Held {
  Held(ThiessenInput input, unsigned threads_wanted)
      : settings{input.margin, input.tolerance, input.allow_far},
        study(parts_of(std::move(input), warnings), settings, warnings),
        rainfall(study.weighing(), {}, threads_wanted),
        threads(threads_wanted) {}

  void require_one_each(std::size_t count, const char* of_what) const {
    const std::size_t stations = study.network().stations().size();
    if (count == stations) return;
    throw Error({"", 0,
                 std::to_string(stations) + " stations, and " + std::to_string(count) + " " +
                     of_what + ": one for each is needed",
                 ""});
  }

  Warnings warnings;
  StudySettings settings;
  Study study;
  ArealRainfall rainfall;
  unsigned threads;
};

Thiessen::Thiessen(ThiessenInput input, unsigned threads)
    : held_(std::make_unique<Held>(std::move(input), threads)) {}

Thiessen::~Thiessen() = default;
Thiessen::Thiessen(Thiessen&&) noexcept = default;
Thiessen& Thiessen::operator=(Thiessen&&) noexcept = default;

const std::vector<Message>& Thiessen::warnings() const {
  return held_->warnings.messages();
}

const std::vector<Station>& Thiessen::stations() const {
  return held_->study.network().stations();
}

const std::vector<Basin>& Thiessen::basins() const {
  return held_->study.basins();
}

const std::vector<BasinWeights>& Thiessen::weights() const {
  return held_->rainfall.full_weights();
}

std::vector<BasinWeights> Thiessen::weights(const std::vector<bool>& reports) const {
  held_->require_one_each(reports.size(), "entries of which report");
  return held_->study.weighing().weights(ReportingStations(reports), held_->threads);
}

std::vector<std::vector<StationCell>> Thiessen::cells() const {
  return held_->study.weighing().cells(held_->study.all_report(), held_->threads);
}

std::vector<BasinRainfall> Thiessen::rainfall(std::span<const double> readings) const {
  held_->require_one_each(readings.size(), "readings");
  for (std::size_t i = 0; i < readings.size(); ++i) {
    if (std::isinf(readings[i]))
      throw Error({"", 0, "the reading of " + named(stations()[i]) + " is not finite", ""});
    if (readings[i] < 0)
      throw Error({"", 0, "the reading of " + named(stations()[i]) + " is negative", ""});
  }
  return held_->rainfall.at(readings);
}

}  // namespace thiessen

#include "study/thiessen.h"

#include <cmath>
#include <string>
#include <utility>

#include "base/default_arithmetic.h"
#include "base/utf8.h"
#include "rainfall/areal_rainfall.h"
#include "rainfall/normals/uniform_normals.h"
#include "study/basin_placing.h"
#include "study/coordinate_checks.h"
#include "study/given_lists.h"
#include "study/study.h"

namespace thiessen {
namespace {

constexpr CoordinateKind degrees{true, 1};

std::string named(const Station& station) {
  return "station " + quoted(station.id, 80);
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

/// The normals that are given; null where there are none.
std::shared_ptr<const NormalField> normals_of(const ThiessenInput& input) {
  if (input.station_normals.empty() && input.basin_normals.empty()) return nullptr;
  Complaints complaints;
  const auto by_one = [&](const std::vector<double>& normals, std::size_t count, const char* what) {
    if (normals.size() != count) {
      complaints.add({"", 0,
                      std::to_string(count) + " " + what + ", and " +
                          std::to_string(normals.size()) + " normals: one for each is needed",
                      ""});
    }
    std::vector<std::vector<double>> all;
    for (std::size_t i = 0; i < normals.size(); ++i) {
      if (!std::isfinite(normals[i]) || normals[i] <= 0) {
        complaints.add(
            {"", 0,
             "the normal of number " + std::to_string(i) + " of the " + what + " is not above 0",
             ""});
      }
      all.push_back({normals[i]});
    }
    return all;
  };
  auto stations = by_one(input.station_normals, input.stations.size(), "stations");
  const bool has_basins = !input.basins.empty();
  const auto basins = by_one(input.basin_normals, has_basins ? input.basins.size() : 1,
                             has_basins ? "basins" : "study area");
  complaints.throw_if_any();
  return std::make_shared<const UniformNormals>(std::move(stations), basins);
}

std::shared_ptr<StudyParts> parts_of(ThiessenInput input, Warnings& warnings) {
  check_settings(input);
  const bool on_earth = input.metric == Metric::geodesic;
  StationList stations = given_stations(std::move(input.stations));
  BasinList basins = given_basins(std::move(input.basins));
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
        normals(normals_of(input)),
        study(parts_of(std::move(input), warnings), settings, warnings),
        rainfall(weighing(), {}, threads_wanted),
        threads(threads_wanted) {}

  const Weighing& weighing() {
    if (normals) study.take_normals(normals);
    return study.weighing();
  }

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
  std::shared_ptr<const NormalField> normals;
  Study study;
  ArealRainfall rainfall;
  unsigned threads;
};

Thiessen::Thiessen(ThiessenInput input, unsigned threads) {
  const DefaultArithmetic arithmetic;
  held_ = std::make_unique<Held>(std::move(input), threads);
}

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
  const DefaultArithmetic arithmetic;
  held_->require_one_each(reports.size(), "entries of which report");
  return held_->study.weighing().weights(ReportingStations(reports), held_->threads);
}

std::vector<std::vector<StationCell>> Thiessen::cells() const {
  const DefaultArithmetic arithmetic;
  return held_->study.weighing().cells(held_->study.all_report(), held_->threads);
}

std::vector<BasinRainfall> Thiessen::rainfall(std::span<const double> readings) const {
  const DefaultArithmetic arithmetic;
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

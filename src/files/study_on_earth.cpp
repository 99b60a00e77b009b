#include "files/study_on_earth.h"

#include <cmath>
#include <utility>

#include "base/utf8.h"
#include "gdal/crs/shape_tracer.h"
#include "gdal/crs/transformation.h"
#include "outlines/longitudes.h"
#include "study/basin_placing.h"

namespace thiessen {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw Error(Message{{}, 0, what + " lies outside the projection's area", {}});
}

std::vector<Station> stations_on_earth(const StudyFiles& study, const Network& network,
                                       const Crs& degrees) {
  std::vector<Station> stations = network.stations();
  std::vector<Point> points;
  points.reserve(stations.size());
  for (const Station& station : stations) points.push_back(station.position);
  const std::vector<bool> inside = Transformation(*study.crs, degrees).apply(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!inside[i]) fail("station " + quoted(stations[i].id, 80));
    if (std::abs(points[i].x) > 180) points[i].x = std::remainder(points[i].x, 360);
    stations[i].position = points[i];
  }
  return stations;
}

/// The basins as their file has them, or where there are none the study area.
const MultiPolygon& shape_of(const StudyFiles& study, std::size_t basin) {
  return study.has_basins ? study.native_basins[basin] : study.basins[basin].shape;
}

std::vector<Basin> basins_on_earth(const StudyFiles& study, const Crs& degrees,
                                   double chord_error) {
  const Crs& from = study.has_basins ? *study.basins_crs : *study.crs;
  ShapeTracer tracer = tracer_between(from, degrees, chord_error, Course::chords_and_bulges);
  std::vector<Basin> basins;
  for (std::size_t i = 0; i < study.basins.size(); ++i) {
    Basin basin{study.basins[i].id, shape_of(study, i), {}};
    const std::string name = "basin " + quoted(basin.id, 80);
    if (from.kind().in_degrees()) {
      // In a plane of degrees longitudes did not run on over the antimeridian.
      WideEdges wide;  // told where the basins were put right
      const std::string fault = unwrap_longitudes(basin.shape, wide);
      if (!fault.empty()) throw Error(Message{{}, 0, name + ": " + fault, {}});
    }
    if (!from.same_as(degrees)) {
      auto traced = tracer.trace(basin.shape, Longitudes::run_on);
      if (!traced) fail(name);
      basin.shape = std::move(traced->shape);
      basin.bulges = std::move(traced->bulges);
    }
    basins.push_back(std::move(basin));
  }
  bring_basins_together(basins);
  return basins;
}

}  // namespace

StudyParts study_on_earth(const StudyFiles& study, const Network& network, double chord_error) {
  Crs degrees = Crs::wgs84();
  if (study.crs->area()) degrees = degrees.over(*study.crs->area());
  StudyParts parts;
  parts.metric = Metric::geodesic;
  parts.stations = stations_on_earth(study, network, degrees);
  parts.basins = basins_on_earth(study, degrees, chord_error);
  parts.has_basins = study.has_basins;
  return parts;
}

}  // namespace thiessen

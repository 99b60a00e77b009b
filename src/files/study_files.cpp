#include "files/study_files.h"
#include "gdal/crs/transformation.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <iterator>
#include <numbers>
#include <set>
#include <system_error>
#include <utility>

#include "base/number.h"
#include "base/parallel.h"
#include "base/utf8.h"
#include "files/basin_tracing.h"
#include "files/far_files.h"
#include "files/places/crs_agreement.h"
#include "files/places/datums.h"
#include "files/plane/plane_choice.h"
#include "files/plane/plane_mapping.h"
#include "gdal/crs/shape_tracer.h"
#include "gdal/layers/opening.h"
#include "study/basin_placing.h"
#include "study/coordinate_checks.h"

namespace thiessen {
namespace {

constexpr std::size_t no_line = 0;  // line of a gauge that the file lacks

std::string coordinates(Point point) {
  return shortest_text(point.x) + " " + shortest_text(point.y);
}

/// The latitudes of the shape's own vertices on the antimeridian, so that vertices that cutting
/// adds there can be told from them.
std::set<double> latitudes_on_antimeridian(const MultiPolygon& shape) {
  std::set<double> latitudes;
  const auto ring = [&](const Ring& points) {
    for (const Point point : points) {
      if (std::abs(std::remainder(point.x, 360)) == 180) latitudes.insert(point.y);
    }
  };
  for (const Polygon& polygon : shape) {
    ring(polygon.outer);
    std::for_each(polygon.holes.begin(), polygon.holes.end(), ring);
  }
  return latitudes;
}

/// Brings the stations and basins of two files into one system of coordinates.
class StudyMaker {
 public:
  StudyMaker(StationsFile stations, std::optional<BasinsFile> basins, const StudyRequest& request,
             Warnings& warnings)
      : request_(request),
        warnings_(warnings),
        stations_(std::move(stations)),
        basins_(std::move(basins)) {}

  StudyFiles make() {
    agree_on_crs(stations_, basins_ ? &*basins_ : nullptr, asked(), warnings_);
    choose_coordinates();
    open_gauges();
    settle_datums(stations_, basins_ ? &*basins_ : nullptr, study_.crs, warnings_);
    tell_extents();
    mend_basins();
    make_plane();
    bring_stations();
    bring_basins();
    bring_basins_together();
    if (study_.crs && planar_degrees()) {
      require_one_turn();
      warn_of_degrees();
    }
    finish();
    return std::move(study_);
  }

 private:
  Asked asked() const {
    if (!request_.plane.empty() || request_.metric == Metric::geodesic) return Asked::crs;
    return request_.metric ? Asked::plane : Asked::nothing;
  }

  void choose_coordinates() {
    if (request_.plane == automatic_plane) {
      require_crs(setting("plane", automatic_plane));
      study_.crs = Crs::wgs84();  // until make_plane knows where the basins are
      return;
    }
    if (!request_.plane.empty()) {
      study_.crs = Crs::from_text(request_.plane, setting("plane"));
      require_crs(setting("plane"));
      return;
    }
    study_.metric = request_.metric.value_or(stations_.crs ? Metric::geodesic : Metric::planar);
    if (study_.metric == Metric::geodesic) {
      require_crs(setting("metric", "geodesic"));
      study_.crs = Crs::wgs84();
    } else {
      study_.crs = basins_ && basins_->crs ? basins_->crs : stations_.crs;
    }
  }

  // Adds the opened gauges behind those of the file, whose CRS they share.
  void open_gauges() {
    if (request_.opened.empty()) return;
    std::set<std::string> ids;
    for (const Station& station : stations_.stations) ids.insert(station.id);
    StationsFile opened;
    opened.file = request_.opened_from;
    for (const Point at : request_.opened) {
      std::string id = "with " + std::to_string(opened.stations.size() + 1);
      while (ids.contains(id)) id += '\'';
      opened.stations.push_back({id, {at.x + 0.0, at.y + 0.0}, no_line});
    }
    if (stations_.crs && stations_.crs->geographic()) {
      require_degrees(opened, stations_.crs->kind());
      if (!planar_degrees()) turn_longitudes(opened, stations_.crs->kind(), warnings_);
    }
    study_.opened = opened.stations.size();
    study_.opened_from = request_.opened_from;
    std::move(opened.stations.begin(), opened.stations.end(),
              std::back_inserter(stations_.stations));
  }

  std::string file_of(const Station& station) const {
    return station.line == no_line ? request_.opened_from : stations_.file;
  }

  void require_crs(const Wording& what) const {
    const bool known = stations_.crs && (!basins_ || basins_->crs);
    if (known) return;
    throw Error(
        Message{stations_.file, 0, what + " needs to know the CRS of the coordinates",
                "name it with " + setting("crs") + " (EPSG:4326 for longitude and latitude)"});
  }

  bool planar_degrees() const {
    return study_.metric == Metric::planar && study_.crs->geographic() &&
           request_.plane != automatic_plane;
  }

  // Fits the plane to the study where one is to be made. Its CRS is the plane's text, by which
  // files are written; coordinates come into it by GeographicLib.
  void make_plane() {
    if (request_.plane != automatic_plane) return;
    degrees_ = study_.crs;
    const auto basins_crs = basins_ ? basins_->crs : std::nullopt;
    study_.plane = choose_plane(stations_, study_.native_basins, basins_crs, *degrees_, warnings_);
    study_.crs = Crs::from_text(study_.plane->plane.proj_text(), setting("plane", automatic_plane));
    if (degrees_->area()) study_.crs = study_.crs->over(*degrees_->area());
  }

  std::shared_ptr<const Mapping> mapping_from(const Crs& from) const {
    if (study_.plane) return std::make_shared<PlaneMapping>(from, *degrees_, study_.plane->plane);
    return std::make_shared<Transformation>(from, *study_.crs);
  }

  void warn_of_degrees() {
    Reach reach;
    for (const Station& station : study_.stations) reach.see(station.position);
    const double latitude = (reach.south + reach.north) / 2;
    const double percent = 100 * (1 - std::cos(latitude * std::numbers::pi / 180));
    warnings_.add({stations_.file, 0,
                   "distances are planar in degrees: at latitude " + fixed_text(latitude, 1) +
                       " a degree from west to east is " + fixed_text(percent, 1) +
                       " % shorter than one from south to north",
                   setting("metric", "geodesic") + ", or " + setting("plane") +
                       " with a projected CRS, measures the Earth"});
  }

  void require_one_turn() const {
    const double unit = study_.crs->degrees_per_unit();
    LongitudeRange range;
    for (const Station& station : study_.stations) {
      range.see(station.position.x * unit, "station " + quoted(station.id, 80), file_of(station),
                stations_.has_lines ? station.line : 0);
    }
    for (std::size_t i = 0; i < study_.basins.size(); ++i) {
      const RawBasin& basin = basins_->basins[i];
      for (const Polygon& polygon : study_.basins[i].shape) {
        const auto [west, east] = std::minmax_element(polygon.outer.begin(), polygon.outer.end());
        range.see(west->x * unit, basin.place, basins_->file, basin.line);
        range.see(east->x * unit, basin.place, basins_->file, basin.line);
      }
    }
    range.require_one_turn();
  }

  // Tells where gauges and basins are, in the coordinates that the user knows.
  void tell_extents() {
    if (!study_.crs || !basins_) return;
    study_.gauges_extent = extent_text(reach_of(stations_), *stations_.crs);
    study_.basins_extent = extent_text(reach_of(*basins_), *basins_->crs);
  }

  void mend_basins() {
    if (!basins_) return;
    const bool wraps = basins_->crs && basins_->crs->kind().in_degrees() && !planar_degrees();
    for (const RawBasin& basin : basins_->basins) {
      on_antimeridian_.push_back(wraps ? latitudes_on_antimeridian(basin.polygons)
                                       : std::set<double>());
    }
    MendingRules rules{request_.mend, wraps, {}};
    if (basins_->crs) rules.kind = basins_->crs->kind();
    study_.native_basins = thiessen::mend_basins(*basins_, rules, warnings_, request_.threads);
  }

  void bring_stations() {
    if (study_.crs && stations_.crs && stations_.crs->geographic() && !planar_degrees()) {
      turn_longitudes(stations_, stations_.crs->kind(), warnings_);
    }
    study_.stations = std::move(stations_.stations);
    if (!study_.crs) return;
    std::vector<Point> points;
    points.reserve(study_.stations.size());
    for (const Station& station : study_.stations) points.push_back(station.position);
    const std::vector<bool> inside = mapping_from(*stations_.crs)->apply(points);
    Complaints complaints;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (study_.stations[i].position == Point{0, 0})
        study_.at_zero.push_back(study_.stations[i].id);
      if (!inside[i]) {
        complain_of_area(study_.stations[i], complaints);
      } else if (study_.metric == Metric::geodesic && std::abs(points[i].x) > 180) {
        points[i].x = std::remainder(points[i].x, 360);
      }
      study_.stations[i].position = points[i];
    }
    complaints.throw_if_any();
  }

  void complain_of_area(const Station& station, Complaints& complaints) const {
    const bool is_feature = !stations_.has_lines && station.line != no_line;
    const std::string where = is_feature ? "feature " + std::to_string(station.line) + ": " : "";
    complaints.add({file_of(station),
                    stations_.has_lines ? station.line : 0,
                    where + "station " + quoted(station.id, 80) + " at " +
                        coordinates(station.position) + " lies outside the projection's area (" +
                        projections(*stations_.crs) + ")",
                    {}});
  }

  /// Names the projections between two CRSs for a message: `EPSG:32633`, or both where both are
  /// projected.
  std::string projections(const Crs& from) const {
    if (from.geographic()) return study_.crs->name();
    return study_.crs->geographic() ? from.name() : from.name() + " to " + study_.crs->name();
  }

  void bring_basins() {
    if (!basins_) return;
    Complaints complaints;
    for (std::size_t i = 0; i < study_.native_basins.size(); ++i) {
      Basin basin{basins_->basins[i].id, {}, {}};
      if (!study_.crs || (!study_.plane && basins_->crs->same_as(*study_.crs))) {
        basin.shape = study_.native_basins[i];
      } else if (study_.metric == Metric::geodesic) {
        trace(i, basin, complaints);
      } else {
        project(i, basin, complaints);
      }
      study_.basins.push_back(std::move(basin));
    }
    complaints.throw_if_any();
  }

  void complain_of_area(std::size_t i, Point point, Complaints& complaints) const {
    const RawBasin& basin = basins_->basins[i];
    complaints.add({basins_->file,
                    basin.line,
                    basin.place + ": the point " + coordinates(point) +
                        " lies outside the projection's area (" + projections(*basins_->crs) + ")",
                    {}});
  }

  /// Subdivides every edge so that it follows its true course over the ellipsoid.
  void trace(std::size_t i, Basin& basin, Complaints& complaints) {
    if (!tracing_) tracing_.emplace(*basins_->crs, *study_.crs, Yardstick::measuring_tolerance);
    auto traced = tracing_->trace(study_.native_basins[i]);
    if (!traced) return complain(i, *tracing_, complaints);
    if (tracing_->collapsed() > 0) {
      tell_of_basin(i, "is without needles and slivers narrower than " +
                           shortest_text(std::round(1e7 * tracing_->collapsed()) / 1e4) +
                           " mm: rounding would make it cross itself there");
    }
    take(*std::move(traced), basin);
    if (request_.tolerance == Yardstick::measuring_tolerance) return;
    if (!drawing_) drawing_.emplace(*basins_->crs, *study_.crs, request_.tolerance);
    MultiPolygon to_draw = study_.native_basins[i];
    auto drawn = drawing_->trace(to_draw);
    if (!drawn) return complain(i, *drawing_, complaints);
    study_.drawn_basins.push_back({basin.id, std::move(drawn->shape), {}});
  }

  void tell_of_basin(std::size_t i, const std::string& text) {
    const RawBasin& basin = basins_->basins[i];
    warnings_.add({basins_->file, basin.line, basin.place + " " + text, {}});
  }

  void complain(std::size_t i, const BasinTracing& tracing, Complaints& complaints) const {
    if (tracing.fault().empty()) return complain_of_area(i, tracing.outside(), complaints);
    complain_of_crossing(i, "longitude and latitude", tracing.fault(), complaints);
  }

  /// Takes the vertices into the plane and subdivides no edge: edges are straight in the plane.
  void project(std::size_t i, Basin& basin, Complaints& complaints) {
    constexpr double untorn = 1e5;  // metres
    if (!tracer_) {
      tracer_ = study_.plane
                    ? ShapeTracer(mapping_from(*basins_->crs), PlanePoles(), untorn, Course::ends)
                    : tracer_between(*basins_->crs, *study_.crs, untorn, Course::ends);
    }
    auto seen = tracer_->trace_without_cuts(study_.native_basins[i], on_antimeridian_[i]);
    if (!seen) return complain_of_area(i, tracer_->outside(), complaints);
    const PlaneMending mending = make_valid_in_plane(seen->shape);
    if (!mending.fault.empty())
      return complain_of_crossing(i, "the plane", mending.fault, complaints);
    if (mending.redrawn)
      tell_of_basin(
          i, "is mended where its edges cross in the plane: each piece of ground counts once");
    take(*std::move(seen), basin);
  }

  void complain_of_crossing(std::size_t i, const std::string& where, const std::string& fault,
                            Complaints& complaints) const {
    const RawBasin& basin = basins_->basins[i];
    complaints.add(
        {basins_->file, basin.line, basin.place + " crosses itself in " + where + ": " + fault,
         "more vertices on its edges, or a smaller " + setting("tolerance") + ", keep them apart"});
  }

  static void take(CurvedShape brought, Basin& basin) {
    basin.shape = std::move(brought.shape);
    basin.bulges = std::move(brought.bulges);
  }

  // Basins on both sides of the antimeridian would otherwise lie far apart.
  void bring_basins_together() {
    if (study_.metric == Metric::geodesic) {
      thiessen::bring_basins_together(study_.basins);
      thiessen::bring_basins_together(study_.drawn_basins);
    }
    if (basins_ && basins_->crs && basins_->crs->degrees_per_unit() == 1)
      thiessen::bring_basins_together(study_.native_basins);
  }

  void finish() {
    study_.has_basins = basins_.has_value();
    study_.stations_file = stations_.file;
    study_.stations_have_lines = stations_.has_lines;
    study_.attributes = std::move(stations_.attributes);
    study_.labels = std::move(stations_.labels);
    study_.station_normals = std::move(stations_.normals);
    study_.station_elevations = std::move(stations_.elevations);
    study_.elevation_field = std::move(stations_.elevation_field);
    if (basins_) study_.basin_normals = std::move(basins_->normals);
    if (basins_) study_.basin_elevations = std::move(basins_->elevations);
    study_.filtered_ids = std::move(stations_.filtered_ids);
    study_.stations_crs = stations_.crs;
    if (basins_) {
      study_.basins_file = basins_->file;
      study_.basins_crs = basins_->crs;
    }
    if (!study_.crs) return;
    if (!study_.crs->geographic()) study_.metres_per_unit = study_.crs->metres_per_unit();
    study_.degrees_per_unit = study_.crs->degrees_per_unit();
    if (!basins_) return;
    study_.far_causes = [stations = *stations_.crs, basins = *basins_->crs, study = *study_.crs] {
      return far_causes_of_files(stations, basins, study);
    };
  }

  const StudyRequest& request_;
  Warnings& warnings_;
  StationsFile stations_;
  std::optional<BasinsFile> basins_;
  StudyFiles study_;
  // For each basin the latitudes of its own vertices on the antimeridian, without those of cuts.
  std::vector<std::set<double>> on_antimeridian_;
  std::optional<ShapeTracer> tracer_;
  std::optional<BasinTracing> tracing_;
  std::optional<BasinTracing> drawing_;  // where edges are drawn more or less finely
  std::optional<Crs> degrees_;  // WGS 84 over the study's area, on the way to a plane made for it
};

/// Whether a source is a text on the disk, of which GDAL is asked no more than what a geometry
/// says.
bool is_text_on_disk(const Source& source) {
  std::error_code error;
  if (!source.where.empty() || !std::filesystem::is_regular_file(source.file, error)) return false;
  try {
    return !read_by_gdal(source.file);
  } catch (const Error&) {  // the format is another, or what is wrong is told when it is read
    return false;
  }
}

/// Whether two threads may read the files.
bool may_be_read_at_once(const StudyRequest& request) {
  return request.threads > 1 && request.basins && is_text_on_disk(request.stations.source) &&
         is_text_on_disk(request.basins->source);
}

}  // namespace

StudyFiles read_study(const StudyRequest& request, Warnings& warnings) {
  std::optional<BasinsFile> basins;
  Warnings of_basins;
  std::exception_ptr fault;
  const auto read_basins_of_request = [&] {
    try {
      if (request.basins) basins = read_basins(*request.basins, of_basins);
    } catch (...) {
      fault = std::current_exception();
    }
  };
  std::optional<StationsFile> stations;
  const auto read_stations_of_request = [&] {
    stations = read_stations(request.stations, warnings);
  };
  if (may_be_read_at_once(request)) {
    side_by_side(read_basins_of_request, read_stations_of_request);
  } else {
    read_stations_of_request();
    read_basins_of_request();
  }
  // What is found in the stations is told first, and alone where it is a fault.
  for (const Message& message : of_basins.messages()) warnings.add(message);
  for (const Message& notice : of_basins.notices()) warnings.add_notice(notice);
  if (fault) std::rethrow_exception(fault);
  return study_of(*std::move(stations), std::move(basins), request, warnings);
}

StudyFiles study_of(StationsFile stations, std::optional<BasinsFile> basins,
                    const StudyRequest& request, Warnings& warnings) {
  return StudyMaker(std::move(stations), std::move(basins), request, warnings).make();
}

}  // namespace thiessen

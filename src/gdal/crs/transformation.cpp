#include "gdal/crs/transformation.h"

#include <ogr_spatialref.h>

#include <cmath>
#include <utility>

#include "gdal/crs/coordinate_operation.h"
#include "gdal/crs/crs_definition.h"

namespace thiessen {
namespace {

constexpr double metres_missed_at_most = 0.1;
constexpr double metres_per_degree = 111320;

/// The distance from a to b in metres, or nearly so; coordinates are those of `crs`.
double metres_apart(const Crs& crs, Point a, Point b) {
  if (!crs.geographic()) return std::hypot(b.x - a.x, b.y - a.y) * crs.metres_per_unit();
  const double degrees = crs.degrees_per_unit();
  const double shrinks = std::cos(a.y * degrees * std::acos(-1.0) / 180);
  const double east = std::remainder((b.x - a.x) * degrees, 360) * shrinks;
  return std::hypot(east, (b.y - a.y) * degrees) * metres_per_degree;
}

/// The area, in degrees, for which a CRS is meant, as its authority states it.
struct AreaOfUse {
  double west = -180;
  double south = -90;
  double east = 180;
  double north = 90;

  /// Whether a point lies within the area or 20 degrees of it: neighbouring zones are often drawn
  /// in one, but the other side of the Earth never is.
  bool reaches(Point at) const {
    constexpr double margin = 20;
    const double width = west <= east ? east - west : east - west + 360;
    const double from_west = std::remainder(at.x - (west + width / 2), 360);
    return std::abs(from_west) <= width / 2 + margin && at.y >= south - margin &&
           at.y <= north + margin;
  }
};

AreaOfUse area_of_use(const Crs& crs) {
  AreaOfUse area;
  AreaOfUse known;
  if (!crs.geographic() &&
      crs.definition().system.GetAreaOfUse(&known.west, &known.south, &known.east, &known.north,
                                           nullptr) &&
      known.west >= -180) {
    area = known;
  }
  return area;
}

}  // namespace

struct Transformation::Proj {
  Crs from;
  Crs to;
  std::optional<CoordinateOperation> operation;
  bool reversed = false;
  std::optional<CoordinateOperation> degrees;  ///< from `from`, if neither side is WGS 84
  AreaOfUse from_area;
  AreaOfUse to_area;

  void go(std::vector<Point>& points) const {
    if (reversed) {
      operation->back(points);
    } else {
      operation->forth(points);
    }
  }
  /// Transforms the points back, for the proof.
  void return_nearly(std::vector<Point>& points) const {
    if (reversed) {
      operation->forth(points);
    } else {
      operation->back_nearly(points);
    }
  }
  /// Longitudes and latitudes of the points `here`, which are `there` in `to`; empty where they are
  /// not known.
  std::vector<Point> degrees_of(const std::vector<Point>& here,
                                const std::vector<Point>& there) const {
    if (from.is_wgs84()) return here;
    if (to.is_wgs84()) return there;
    if (!degrees) return {};
    std::vector<Point> points = here;
    degrees->forth(points);
    return points;
  }
  /// Whether a point of degrees lies where the projection, as those on cylinders do, draws a pole
  /// out to a line, infinitely far away: next to the pole, and where a small step away from it is
  /// much longer than on the Earth.
  bool torn_apart(Point here, Point there) const {
    constexpr double next_to_pole = 89.9;
    constexpr double step = 1e-6;
    constexpr double stretched_at_most = 1000;
    if (!from.geographic() || to.geographic()) return false;
    const double latitude = here.y * from.degrees_per_unit();
    if (std::abs(latitude) < next_to_pole) return false;
    std::vector<Point> beside = {
        {here.x, (latitude - std::copysign(step, latitude)) / from.degrees_per_unit()}};
    go(beside);
    return !(metres_apart(to, there, beside.front()) <=
             stretched_at_most * step * metres_per_degree);
  }
  bool in_use(Point at) const { return from_area.reaches(at) && to_area.reaches(at); }
};

Transformation::Transformation(const Crs& from, const Crs& to)
    : proj_(std::make_unique<Proj>(Proj{from, to, {}, false, {}, {}, {}})) {
  if (from.same_as(to)) return;
  // Both directions must use one operation. PROJ is asked for the one to WGS 84, or where neither
  // side is WGS 84 always for the same of the two.
  proj_->reversed = from.is_wgs84() || (!to.is_wgs84() && to.wkt() < from.wkt());
  const std::optional<Box>& area = from.area() ? from.area() : to.area();
  proj_->operation.emplace(proj_->reversed ? to : from, proj_->reversed ? from : to, area);
  proj_->from_area = area_of_use(from);
  proj_->to_area = area_of_use(to);
  if (!from.is_wgs84() && !to.is_wgs84()) {
    proj_->degrees = CoordinateOperation::rough(from);
  }
}

Transformation::~Transformation() = default;
Transformation::Transformation(Transformation&&) noexcept = default;
Transformation& Transformation::operator=(Transformation&&) noexcept = default;

CoordinateKind Transformation::from() const {
  return proj_->from.kind();
}

CoordinateKind Transformation::to() const {
  return proj_->to.kind();
}

bool Transformation::identity() const {
  return !proj_->operation;
}

const OperationChoice* Transformation::choice() const {
  return proj_->operation ? &proj_->operation->choice() : nullptr;
}

void Transformation::apply_unproved(std::vector<Point>& points) const {
  if (!identity()) proj_->go(points);
}

std::vector<bool> Transformation::apply(std::vector<Point>& points) const {
  std::vector<bool> inside(points.size(), true);
  if (identity()) return inside;
  std::vector<Point> there = points;
  proj_->go(there);
  std::vector<Point> returned = there;
  proj_->return_nearly(returned);
  const std::vector<Point> degrees = proj_->degrees_of(points, there);
  for (std::size_t i = 0; i < points.size(); ++i) {
    inside[i] = metres_apart(proj_->from, points[i], returned[i]) <= metres_missed_at_most &&
                (degrees.empty() || proj_->in_use(degrees[i])) &&
                !proj_->torn_apart(points[i], there[i]);
    if (inside[i]) points[i] = there[i];
  }
  return inside;
}

bool take_roughly_to_degrees(const Crs& from, std::vector<Point>& points) {
  if (from.is_wgs84()) return true;
  const auto degrees = CoordinateOperation::rough(from);
  if (degrees) degrees->forth(points);
  return degrees.has_value();
}

}  // namespace thiessen

#include <ogr_spatialref.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "io/crs.h"
#include "io/crs_definition.h"
#include "io/gdal_errors.h"

namespace thiessen {
namespace {

constexpr double metres_missed_at_most = 0.1;
constexpr double metres_per_degree = 111320;

using OgrTransformation = std::unique_ptr<OGRCoordinateTransformation>;

/// How far b lies from a, in metres or nearly so; coordinates in `crs`.
double metres_apart(const Crs& crs, Point a, Point b) {
  if (!crs.geographic()) return std::hypot(b.x - a.x, b.y - a.y) * crs.metres_per_unit();
  const double degrees = crs.degrees_per_unit();
  const double shrinks = std::cos(a.y * degrees * std::acos(-1.0) / 180);
  const double east = std::remainder((b.x - a.x) * degrees, 360) * shrinks;
  return std::hypot(east, (b.y - a.y) * degrees) * metres_per_degree;
}

/// Where a CRS is meant to be used, as its authority states it, in degrees.
struct AreaOfUse {
  double west = -180;
  double south = -90;
  double east = 180;
  double north = 90;

  /// Neighbouring zones are often drawn in one; the other side of the Earth never is.
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

OgrTransformation to_degrees(const Crs& crs) {
  const std::unique_ptr<OGRSpatialReference> degrees(crs.definition().system.CloneGeogCS());
  if (!degrees) return nullptr;
  degrees->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return OgrTransformation(
      OGRCreateCoordinateTransformation(&crs.definition().system, degrees.get()));
}

void transform(OGRCoordinateTransformation& by, std::vector<Point>& points) {
  std::vector<double> x(points.size());
  std::vector<double> y(points.size());
  std::transform(points.begin(), points.end(), x.begin(), [](Point p) { return p.x; });
  std::transform(points.begin(), points.end(), y.begin(), [](Point p) { return p.y; });
  std::vector<int> done(points.size(), 0);
  const GdalErrors errors;
  // The count is an int: more points than that go in slices.
  constexpr std::size_t slice = 1U << 20U;
  for (std::size_t at = 0; at < points.size(); at += slice) {
    const int count = static_cast<int>(std::min(slice, points.size() - at));
    by.Transform(count, x.data() + at, y.data() + at, nullptr, done.data() + at);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool good = done[i] != 0 && std::isfinite(x[i]) && std::isfinite(y[i]);
    const double none = std::numeric_limits<double>::quiet_NaN();
    points[i] = good ? Point{x[i], y[i]} : Point{none, none};
  }
}

}  // namespace

struct Transformation::Proj {
  Crs from;
  Crs to;
  OgrTransformation forward;
  OgrTransformation back;
  OgrTransformation degrees;  ///< from `from`, where neither side is geographic
  AreaOfUse from_area;
  AreaOfUse to_area;

  bool in_use(Point degrees_at) const {
    return from_area.reaches(degrees_at) && to_area.reaches(degrees_at);
  }
};

Transformation::Transformation(const Crs& from, const Crs& to)
    : proj_(std::make_unique<Proj>(Proj{from, to, {}, {}, {}, {}, {}})) {
  if (from.same_as(to)) return;
  const GdalErrors errors;
  proj_->forward.reset(
      OGRCreateCoordinateTransformation(&from.definition().system, &to.definition().system));
  if (proj_->forward) proj_->back.reset(proj_->forward->GetInverse());
  if (!proj_->back) {
    throw Error(Message{{},
                        0,
                        "no transformation from " + from.name() + " to " + to.name() +
                            " is known: " + errors.text(),
                        {}});
  }
  proj_->from_area = area_of_use(from);
  proj_->to_area = area_of_use(to);
  if (!from.geographic() && !to.geographic()) proj_->degrees = to_degrees(from);
}

Transformation::~Transformation() = default;
Transformation::Transformation(Transformation&&) noexcept = default;
Transformation& Transformation::operator=(Transformation&&) noexcept = default;

bool Transformation::identity() const {
  return proj_->forward == nullptr;
}

void Transformation::apply_unproved(std::vector<Point>& points) const {
  if (!identity()) transform(*proj_->forward, points);
}

std::vector<bool> Transformation::apply(std::vector<Point>& points) const {
  std::vector<bool> inside(points.size(), true);
  if (identity()) return inside;
  std::vector<Point> there = points;
  transform(*proj_->forward, there);
  std::vector<Point> returned = there;
  transform(*proj_->back, returned);
  std::vector<Point> degrees = proj_->from.geographic() ? points : there;
  if (proj_->degrees) {
    degrees = points;
    transform(*proj_->degrees, degrees);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    inside[i] = metres_apart(proj_->from, points[i], returned[i]) <= metres_missed_at_most &&
                proj_->in_use(degrees[i]);
    if (inside[i]) points[i] = there[i];
  }
  return inside;
}

std::optional<Point> Transformation::operator()(Point point) const {
  std::vector<Point> one = {point};
  if (!apply(one)[0]) return std::nullopt;
  return one[0];
}

}  // namespace thiessen

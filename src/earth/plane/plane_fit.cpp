#include "earth/plane/plane_fit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <vector>

#include "earth/plane/outermost_points.h"
#include "earth/sphere/units.h"
#include "geometry/predicates.h"

namespace thiessen {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double half_turn = 180;
constexpr double half = 0.5;

double rounded(double value, double per_unit) {
  return std::round(value * per_unit) / per_unit;
}
double rounded_degrees(double value) {
  return rounded(std::remainder(value, 360), 1e3);
}

/// The least and the largest scale in a study.
struct ScaleRange {
  double least = infinite;
  double largest = 0;
  double south = 90;
  double north = -90;

  void see(const ConformalPlane& plane, Point degrees) {
    const double scale = plane.scale_at(degrees);
    least = std::min(least, scale);
    largest = std::isfinite(scale) ? std::max(largest, scale) : infinite;
    south = std::min(south, degrees.y);
    north = std::max(north, degrees.y);
  }
  double error() const { return largest < infinite ? (largest - least) / (largest + least) : 1.0; }
};

/// The convex hull, counter-clockwise from its lowest point (A. M. Andrew's chains, 1979).
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point> hull;
  const auto chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= first + 2 && orientation(hull[hull.size() - 2], hull.back(), *p) <= 0)
        hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();
  };
  chain(points.begin(), points.end());
  chain(points.rbegin(), points.rend());
  return hull;
}

bool holds_origin(const std::vector<Point>& hull) {
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (orientation(hull[i], hull[(i + 1) % hull.size()], {0, 0}) < 0) return false;
  }
  return hull.size() > 2;
}

/// Whether the line or the point at which the projection's scale is least lies in the study.
bool holds_least_scale(const ConformalPlane& plane, const std::vector<Point>& hull,
                       const ScaleRange& range) {
  switch (plane.parameters().kind) {
    case ProjectionKind::transverse_mercator: {
      const auto [west, east] = std::minmax_element(hull.begin(), hull.end());
      return west->x <= 0 && east->x >= 0;
    }
    case ProjectionKind::lambert_conformal:
      return range.south <= plane.parameters().latitude &&
             range.north >= plane.parameters().latitude;
    case ProjectionKind::polar_stereographic:
      return holds_origin(hull);
  }
  throw std::logic_error("not a kind of projection");
}

/// The scales of the plane along the outline of the study, and at its least if that lies inside.
/// Requires a plane whose scale is 1 at the least.
ScaleRange scales_in(const ConformalPlane& plane, const std::vector<Point>& points) {
  constexpr double pieces = 256;
  ScaleRange range;
  std::vector<Point> projected;
  for (const Point p : points) {
    range.see(plane, p);
    projected.push_back(plane.forward(p));
    if (!std::isfinite(projected.back().x) || !std::isfinite(projected.back().y))
      return {0, infinite};
  }
  const std::vector<Point> hull = convex_hull(std::move(projected));
  double perimeter = 0;
  const auto length_from = [&](std::size_t i) {
    const Point a = hull[i];
    const Point b = hull[(i + 1) % hull.size()];
    return std::hypot(b.x - a.x, b.y - a.y);
  };
  for (std::size_t i = 0; i < hull.size(); ++i) perimeter += length_from(i);
  for (std::size_t i = 0; perimeter > 0 && i < hull.size(); ++i) {
    const Point a = hull[i];
    const Point b = hull[(i + 1) % hull.size()];
    const int parts = static_cast<int>(std::ceil(length_from(i) / perimeter * pieces));
    for (int k = 1; k < parts; ++k) {
      const double share = static_cast<double>(k) / parts;
      range.see(plane, plane.reverse({a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}));
    }
  }
  if (holds_least_scale(plane, hull, range)) range.least = std::min(range.least, 1.0);
  return range;
}

/// The argument of the least value of a function that falls and then rises, by golden sections.
double least_of(double low, double high, const std::function<double(double)>& value) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double first = high - golden * (high - low);
  double second = low + golden * (high - low);
  double at_first = value(first);
  double at_second = value(second);
  while (high - low > 1e-4) {
    if (at_first <= at_second) {
      high = second;
      second = first;
      at_second = at_first;
      first = high - golden * (high - low);
      at_first = value(first);
    } else {
      low = first;
      first = second;
      at_first = at_second;
      second = low + golden * (high - low);
      at_second = value(second);
    }
  }
  return (low + high) / 2;
}

/// Gives the plane the k_0 for which the least and the largest scale are equally far from 1. It is
/// rounded; and GDAL takes what is nearer to 1 than 1e-8 for 1, so this is 1 here too.
StudyPlane balanced(PlaneParameters parameters, const ScaleRange& range) {
  constexpr double taken_for_one = 1.5e-8;
  // Beyond a half no scale makes the plane sensible.
  if (range.error() >= half) return {ConformalPlane(parameters), range.error()};
  const double scale = rounded(2 / (range.least + range.largest), 1e8);
  parameters.scale = std::abs(scale - 1) < taken_for_one ? 1 : scale;
  return {ConformalPlane(parameters),
          std::max(range.largest * parameters.scale - 1, 1 - range.least * parameters.scale)};
}

/// Nothing where a point is farther than `side` degrees of longitude from every central meridian.
std::optional<StudyPlane> transverse_mercator(const OutermostPoints& study) {
  constexpr double side = 89;
  const double east = study.west + study.width;
  const double first = std::max(study.west, east - side);
  const double last = std::min(east, study.west + side);
  if (first > last) return std::nullopt;
  const double middle = least_of(first, last, [&](double longitude) {
    double farthest = 0;  // the sine of the angle between the meridian and the farthest point
    for (const Point p : study.points)
      farthest = std::max(farthest,
                          std::abs(std::cos(p.y * degree) * std::sin((p.x - longitude) * degree)));
    return farthest;
  });
  const PlaneParameters parameters{ProjectionKind::transverse_mercator, rounded_degrees(middle)};
  return balanced(parameters, scales_in(ConformalPlane(parameters), study.points));
}

/// The standard parallel for which two latitudes have one scale, rounded. Near the equator PROJ's
/// cone is so slender that its digits no longer tell micrometres; there it is Mercator's cylinder.
double parallel_between(double south, double north) {
  constexpr double slender = 0.5;
  constexpr double steepest = 89;
  double low = south;
  double high = north;
  for (int i = 0; i < 50 && low < high; ++i) {
    const double middle = (low + high) / 2;
    const ConformalPlane plane({ProjectionKind::lambert_conformal, 0, middle});
    (plane.scale_at({0, south}) < plane.scale_at({0, north}) ? low : high) = middle;
  }
  const double parallel = rounded((low + high) / 2, 1e3);
  if (std::abs(parallel) < slender) return 0;
  return std::clamp(parallel, -steepest, steepest);
}

StudyPlane lambert_conformal(const OutermostPoints& study) {
  PlaneParameters parameters{ProjectionKind::lambert_conformal,
                             rounded_degrees(study.west + study.width / 2)};
  ScaleRange range;
  range.south = study.south;
  range.north = study.north;
  // Straight lines leave the points' latitudes, and by how much depends on the parallel.
  for (int i = 0; i < 4; ++i) {
    parameters.latitude = parallel_between(range.south, range.north);
    range = scales_in(ConformalPlane(parameters), study.points);
  }
  return balanced(parameters, range);
}

StudyPlane polar_stereographic(const OutermostPoints& study) {
  const bool north = study.south + study.north >= 0;
  const double middle = study.width < 360 ? study.west + study.width / 2 : 0;
  const PlaneParameters parameters{ProjectionKind::polar_stereographic, rounded_degrees(middle),
                                   north ? 90.0 : -90.0};
  return balanced(parameters, scales_in(ConformalPlane(parameters), study.points));
}

}  // namespace

std::optional<StudyPlane> fit_plane(std::span<const Point> points) {
  const auto study = outermost_points(points);
  if (!study) return std::nullopt;
  std::vector<StudyPlane> planes;
  if (study->width <= half_turn) {
    if (auto plane = transverse_mercator(*study)) planes.push_back(*std::move(plane));
    planes.push_back(lambert_conformal(*study));
  }
  planes.push_back(polar_stereographic(*study));
  const auto best = std::min_element(
      planes.begin(), planes.end(),
      [](const StudyPlane& a, const StudyPlane& b) { return a.scale_error < b.scale_error; });
  if (!(best->scale_error < 1)) return std::nullopt;
  return *best;
}

}  // namespace thiessen

#include "study/ruler.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/number.h"
#include "earth/sphere/chord_bounds.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

constexpr double half_way_round = 2.0004e7;  // metres, from pole to pole
// The largest radii of curvature of WGS 84, along meridians and along parallels, in metres.
constexpr double longest_meridian_radius = 6399594;
constexpr double longest_parallel_radius = 6399594;

std::string three_digits(double value) {
  constexpr double least = 1e-12;
  return value > least ? significant_text(value, 3) : "0";
}

}  // namespace

Ruler::Ruler(const StudyParts& parts)
    : degrees_(parts.metric == Metric::geodesic ? 1 : parts.degrees_per_unit),
      metres_(parts.metres_per_unit.value_or(1)),
      metres_known_(parts.metres_per_unit.has_value()) {}

Direction Ruler::in_space(Point p) const {
  if (!on_earth()) return {p.x * metres_, p.y * metres_, 0};
  return on_ellipsoid(to_degrees(p));
}

double Ruler::longest(Point a, Point b) const {
  const double x = std::abs(b.x - a.x);
  const double y = std::abs(b.y - a.y);
  if (!on_earth()) return std::hypot(x, y) * metres_;
  const double nearest_to_equator = a.y * b.y <= 0 ? 0 : std::min(std::abs(a.y), std::abs(b.y));
  const double parallel =
      longest_parallel_radius * std::cos(nearest_to_equator * degrees_ * degree);
  return std::hypot(parallel * x, longest_meridian_radius * y) * degrees_ * degree;
}

double Ruler::distance(Point a, Point b) const {
  if (!on_earth()) return std::hypot(b.x - a.x, b.y - a.y) * metres_;
  return geodesic_distance(to_degrees(a), to_degrees(b));
}

Box Ruler::extent(std::span<const Point> points) const {
  Box box;
  for (const Point p : points) box.take_in(p);
  if (!on_earth() || points.empty()) return box;
  const double turn = 360 / degrees_;
  std::vector<double> longitudes;
  longitudes.reserve(points.size());
  for (const Point p : points)
    longitudes.push_back(p.x - turn * std::floor((p.x - box.low.x) / turn));
  std::sort(longitudes.begin(), longitudes.end());
  double widest = longitudes.front() + turn - longitudes.back();
  box.low.x = longitudes.front();
  box.high.x = longitudes.back();
  for (std::size_t i = 1; i < longitudes.size(); ++i) {
    if (longitudes[i] - longitudes[i - 1] <= widest) continue;
    widest = longitudes[i] - longitudes[i - 1];
    box.low.x = longitudes[i];
    box.high.x = longitudes[i - 1] + turn;
  }
  return box;
}

double Ruler::diagonal(const Box& box) const {
  if (on_earth() && box.width() * degrees_ >= 180) return half_way_round;
  return distance(box.low, box.high);
}

double Ruler::between(const Box& a, const Box& b) const {
  double x = std::max({0.0, a.low.x - b.high.x, b.low.x - a.high.x});
  if (on_earth()) {
    const double turn = 360 / degrees_;
    for (const double turns : {-turn, turn})
      x = std::min(x, std::max({0.0, a.low.x + turns - b.high.x, b.low.x - a.high.x - turns}));
  }
  // Which latitudes face each other: those of the gap, or where there is none of the part in
  // common.
  const double low = std::max(a.low.y, b.low.y);
  const double high = std::min(a.high.y, b.high.y);
  const double facing = std::abs(low) > std::abs(high) ? low : high;
  if (low <= high) return distance({0, facing}, {x, facing});
  return distance({0, high}, {x, low});
}

std::string Ruler::text(double distance) const {
  if (knows_metres()) return three_digits(distance / 1000) + " km";
  return three_digits(distance) + " units";
}

std::string Ruler::text(const Box& box) const {
  const auto rounded = [](double v) { return shortest_text(std::round(v * 1e6) / 1e6); };
  const auto range = [&](double low, double high) {
    const std::string from = rounded(low);
    const std::string to = rounded(high);
    return from == to ? from : from + " to " + to;
  };
  const std::string x = range(box.low.x, box.high.x);
  const std::string y = range(box.low.y, box.high.y);
  return on_earth() ? "longitude " + x + ", latitude " + y : "x " + x + ", y " + y;
}

}  // namespace thiessen

#include "earth/equidistance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "earth/conformal_sphere.h"
#include "earth/geodesic.h"

namespace thiessen {
namespace {

// Metres.
constexpr double distance_noise = 3e-8;
constexpr double equal_enough = 1e-7;
constexpr double fine_step = 1e-5;
constexpr double finest_step = 1e-6;
constexpr double longest_step = 2e6;
constexpr double earth_radius = 6371008.8;
constexpr double antipodal = 1.99e7;  // the antipode is 20,004 km away, as the crow flies

struct Step {
  double east;
  double north;
  double length() const { return std::hypot(east, north); }
};

Step minus(const Arrival& a, const Arrival& b) {
  return {a.east - b.east, a.north - b.north};
}

}  // namespace

std::optional<Equidistant> equidistant_point(Point a, Point b, Point c, Point start) {
  constexpr int most_steps = 20;
  Point p = start;
  double before = HUGE_VAL;
  for (int i = 0; i < most_steps; ++i) {
    const Arrival from_a = arrival(a, p);
    const Arrival from_b = arrival(b, p);
    const Arrival from_c = arrival(c, p);
    const double ab = from_a.distance - from_b.distance;
    const double ac = from_a.distance - from_c.distance;
    const double wrong = std::max(std::abs(ab), std::abs(ac));
    const Equidistant here{p, from_a.distance};
    if (wrong <= equal_enough / 2) return here;
    if (i > 3 && wrong > before / 2)
      return wrong <= equal_enough ? std::optional(here) : std::nullopt;
    before = wrong;
    const Step u = minus(from_a, from_b);
    const Step v = minus(from_a, from_c);
    const double determinant = u.east * v.north - u.north * v.east;
    const Step step{(-ab * v.north + ac * u.north) / determinant,
                    (-ac * u.east + ab * v.east) / determinant};
    if (!(step.length() <= longest_step)) return {};
    p = moved(p, step.east, step.north);
    // What a step leaves is of the second order in it.
    const double nearest = std::min({from_a.distance, from_b.distance, from_c.distance});
    if (step.length() * step.length() <= equal_enough / 20 * nearest && from_a.distance < antipodal)
      return Equidistant{p, from_a.distance + from_a.east * step.east + from_a.north * step.north};
  }
  return {};
}

BisectorPoint GeodesicBisector::find(double angle, double offset) const {
  const Point start = from_sphere(arc().at(angle, offset));
  if (const auto found = by_newton(start)) return *found;
  if (const auto p = by_bracket(start)) return {*p};
  return {start};
}

double GeodesicBisector::nearer_to_second(Point p) const {
  return geodesic_distance(first_, p) - geodesic_distance(second_, p);
}

std::optional<BisectorPoint> GeodesicBisector::by_newton(Point start) const {
  constexpr int most_steps = 8;
  constexpr double farthest = 50e3;
  Point p = start;
  double way = 0;
  for (int i = 0; i < most_steps; ++i) {
    const Arrival from_first = arrival(first_, p);
    const Arrival from_second = arrival(second_, p);
    if (from_first.distance > antipodal) return {};
    const double difference = from_first.distance - from_second.distance;
    const Step growth = minus(from_first, from_second);
    const double steepness = growth.length();
    const double length = std::abs(difference) / steepness;
    const double uncertainty = distance_noise / (steepness * earth_radius);
    if (std::abs(difference) <= distance_noise) return BisectorPoint{p, true, uncertainty};
    way += length;
    if (!(way <= farthest)) return {};
    const double scale = -difference / (steepness * steepness);
    p = moved(p, scale * growth.east, scale * growth.north);
    // What is left is of the second order.
    if (length * length <= finest_step * steepness * from_first.distance)
      return BisectorPoint{p, true, uncertainty};
  }
  return {};
}

// Across the great circle, to either side of it, until the difference changes its sign.
std::optional<Point> GeodesicBisector::by_bracket(Point start) const {
  constexpr double first_reach = 500;
  constexpr double last_reach = 200e3;
  const Direction here = on_sphere(start);
  const Direction across = arc().forward();
  const Direction east{-here.y, here.x, 0};
  const double east_length = length(east);
  const Direction unit_east = east_length > 0 ? (1 / east_length) * east : Direction{0, 1, 0};
  const Direction north = cross(here, unit_east);
  const Step direction{dot(across, unit_east), dot(across, north)};
  const auto point_at = [&](double way) {
    return moved(start, way * direction.east, way * direction.north);
  };
  const double middle = nearer_to_second(start);
  if (middle == 0) return start;
  for (double reach = first_reach; reach <= last_reach; reach *= 2) {
    for (const double end : {reach, -reach}) {
      double low = 0;
      double high = end;
      double at_low = middle;
      const double at_high = nearer_to_second(point_at(high));
      if (std::signbit(at_low) == std::signbit(at_high) && at_high != 0) continue;
      while (std::abs(high - low) > fine_step) {
        const double half = low + (high - low) / 2;
        const double at_half = nearer_to_second(point_at(half));
        if (std::signbit(at_half) == std::signbit(at_low)) {
          low = half;
          at_low = at_half;
        } else {
          high = half;
        }
      }
      return point_at(low + (high - low) / 2);
    }
  }
  return {};
}

}  // namespace thiessen

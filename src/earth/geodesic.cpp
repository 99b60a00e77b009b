#include "earth/geodesic.h"

#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Math.hpp>
#include <algorithm>
#include <cmath>

namespace thiessen {
namespace {

using GeographicLib::Geodesic;
using GeographicLib::Math;

/// Up to how long a path, in radians, Simpson's rule is right to a tenth of so many metres: what
/// the great circle is off the geodesic, 1.5e-5 metres at 100 km, grows with the third power.
double longest_by_simpson(double accuracy) {
  constexpr double hundred_km = 0.0157;
  return std::min(3.0, std::cbrt(accuracy / 10 / 1.5e-5)) * hundred_km;
}

}  // namespace

Arrival arrival(const EarthPoint& place, const EarthPoint& at, double accuracy) {
  const Direction chord = at.direction - place.direction;
  const double half = length(chord) / 2;
  if (2 * half > longest_by_simpson(accuracy)) return arrival(place.position, at.position);
  const Direction sum = at.direction + place.direction;
  const double middle = sum.z / length(sum);
  Arrival there{};
  there.distance = 2 * std::asin(half) / 6 *
                   (scale_on_earth(place.direction.z) + 4 * scale_on_earth(middle) +
                    scale_on_earth(at.direction.z));
  const auto [to_east, to_north] = tangent_at(at.direction, chord);
  const double size = std::hypot(to_east, to_north);
  if (size > 0) {
    there.east = to_east / size;
    there.north = to_north / size;
  }
  return there;
}

Arrival arrival(Point place, Point at) {
  Arrival there{};
  double leaving = 0;
  double arriving = 0;
  Geodesic::WGS84().Inverse(place.y, place.x, at.y, at.x, there.distance, leaving, arriving);
  Math::sincosd(arriving, there.east, there.north);
  return there;
}

double geodesic_distance(Point a, Point b) {
  double distance = 0;
  Geodesic::WGS84().Inverse(a.y, a.x, b.y, b.x, distance);
  return distance;
}

Point moved(Point start, double east, double north) {
  const double length = std::hypot(east, north);
  if (length == 0) return start;
  Point end;
  Geodesic::WGS84().Direct(start.y, start.x, Math::atan2d(east, north), length, end.y, end.x);
  return end;
}

}  // namespace thiessen

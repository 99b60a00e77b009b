#include "earth/geodesic.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/Math.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// Metres on the ellipsoid for a radian on the conformal sphere, as a polynomial in the square of
/// the sine of the conformal latitude, by Newton's interpolation: to 1e-13 of it.
class SphereScale {
 public:
  SphereScale() {
    const double a = GeographicLib::Constants::WGS84_a();
    const double e2 =
        GeographicLib::Constants::WGS84_f() * (2 - GeographicLib::Constants::WGS84_f());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      // Chebyshev's nodes, but for the pole itself.
      const double turn =
          (2 * static_cast<double>(i) + 1) / (2 * static_cast<double>(nodes_.size()));
      nodes_[i] = 0.5 - 0.5 * std::cos(turn * std::numbers::pi);
      const double cosine = std::sqrt(1 - nodes_[i]);
      double sine_here = 0;
      double cosine_here = 0;
      Math::sincosd(from_sphere({cosine, 0, std::sqrt(nodes_[i])}).y, sine_here, cosine_here);
      double difference = a * cosine_here / (std::sqrt(1 - e2 * sine_here * sine_here) * cosine);
      for (std::size_t k = 0; k < i; ++k)
        difference = (difference - differences_[k]) / (nodes_[i] - nodes_[k]);
      differences_[i] = difference;
    }
  }
  double at(double sine) const {
    const double square = sine * sine;
    double scale = 0;
    for (std::size_t i = nodes_.size(); i-- > 0;)
      scale = differences_[i] + (square - nodes_[i]) * scale;
    return scale;
  }

 private:
  std::array<double, 7> nodes_{};
  std::array<double, 7> differences_{};
};

}  // namespace

Arrival arrival(const EarthPoint& place, const EarthPoint& at, double accuracy) {
  const Direction chord = at.direction - place.direction;
  const double half = length(chord) / 2;
  if (2 * half > longest_by_simpson(accuracy)) return arrival(place.position, at.position);
  static const SphereScale scale;
  const Direction sum = at.direction + place.direction;
  const double middle = sum.z / length(sum);
  Arrival there{};
  there.distance = 2 * std::asin(half) / 6 *
                   (scale.at(place.direction.z) + 4 * scale.at(middle) + scale.at(at.direction.z));
  const double radius = std::hypot(at.direction.x, at.direction.y);
  const Direction east = radius > 0
                             ? Direction{-at.direction.y / radius, at.direction.x / radius, 0}
                             : Direction{0, 1, 0};
  const double to_east = dot(chord, east);
  const double to_north = dot(chord, cross(at.direction, east));
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

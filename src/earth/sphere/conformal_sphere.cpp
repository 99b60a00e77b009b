#include "earth/sphere/conformal_sphere.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Math.hpp>
#include <numbers>

#include "earth/sphere/latitude_series.h"
#include "earth/sphere/sphere_scale.h"

namespace thiessen {
namespace {

using GeographicLib::Math;

double eccentricity() {
  static const double e = [] {
    const double f = GeographicLib::Constants::WGS84_f();
    return std::sqrt(f * (2 - f));
  }();
  return e;
}

}  // namespace

Direction on_sphere(Point position) {
  double sine = 0;
  double cosine = 0;
  Math::sincosd(position.x, sine, cosine);
  if (std::abs(position.y) == 90) return {0, 0, position.y > 0 ? 1.0 : -1.0};
  const double tangent = Math::taupf(Math::tand(position.y), eccentricity());
  const double radius = 1 / std::sqrt(1 + tangent * tangent);
  return {radius * cosine, radius * sine, radius * tangent};
}

Direction chord_on_sphere(Point a, Point b) {
  constexpr double degree = std::numbers::pi / 180;
  constexpr double near = 5;  // degrees, above which plain differences are right to 1e-15
  const double east = std::remainder(b.x - a.x, 360);
  if (std::abs(b.y - a.y) > near || std::abs(east) > near) return on_sphere(b) - on_sphere(a);
  const double middle = (a.y + (b.y - a.y) / 2) * degree;
  const double rise = (b.y - a.y) * degree;
  // The conformal latitudes lie `half` below and above the middle one.
  const double half = (rise + conformal_series().difference(middle, rise)) / 2;
  const Direction at_a = on_sphere(a);
  const double low = std::atan2(at_a.z, std::sqrt(at_a.x * at_a.x + at_a.y * at_a.y));
  const double sine = std::sin(low + half);
  const double cosine = std::cos(low + half);
  // The chord's components outward and to the east are taken at the meridian halfway between the
  // two points.
  const double turn = east * degree / 2;
  const double outward = -2 * sine * std::sin(half) * std::cos(turn);
  const double eastward = 2 * cosine * std::cos(half) * std::sin(turn);
  double meridian_sine = 0;
  double meridian_cosine = 0;
  Math::sincosd(a.x + east / 2, meridian_sine, meridian_cosine);
  return {meridian_cosine * outward - meridian_sine * eastward,
          meridian_sine * outward + meridian_cosine * eastward, 2 * cosine * std::sin(half)};
}

Point from_sphere(Direction direction) {
  constexpr double degrees = 180 / std::numbers::pi;
  const double square = direction.x * direction.x + direction.y * direction.y;
  if (square == 0) return {0, direction.z > 0 ? 90.0 : -90.0};
  const double radius = std::sqrt(square);
  const double size = std::sqrt(square + direction.z * direction.z);
  const double latitude =
      std::atan2(direction.z, radius) + latitude_series().at(direction.z / size, radius / size);
  return {Math::atan2d(direction.y, direction.x), latitude * degrees};
}

double scale_on_earth(double sine) {
  return sphere_scale().at(sine);
}

Axes axes_at(Direction p) {
  const double radius = std::hypot(p.x, p.y);
  const Direction east =
      radius > 0 ? Direction{-p.y / radius, p.x / radius, 0} : Direction{0, 1, 0};
  return {east, cross(p, east)};
}

Tangent tangent_at(Direction p, Direction vector) {
  const auto [east, north] = axes_at(p);
  return {dot(vector, east), dot(vector, north)};
}

StereographicChart::StereographicChart(Direction pole) : pole_(pole) {
  const Direction axis = std::abs(pole.z) < 0.5 ? Direction{0, 0, 1} : Direction{1, 0, 0};
  east_ = unit(cross(axis, pole));
  north_ = cross(east_, pole);  // so that east, north and -pole are right-handed
}

Point StereographicChart::project(Direction p) const {
  const Direction chord = p - pole_;
  const double scale = 1 / dot(chord, chord);
  return {scale * dot(chord, east_), scale * dot(chord, north_)};
}

// A chord of length s has s in the plane for its projection's distance r: 1 / s^2 = r^2 + 1 / 4.
// Its part along the pole is -s^2 / 2, for both its ends lie on the unit sphere.
Direction StereographicChart::unproject(Point p) const {
  const double square = 1 / (p.x * p.x + p.y * p.y + 0.25);
  return pole_ + (square * p.x * east_ + square * p.y * north_ + -square / 2 * pole_);
}

}  // namespace thiessen

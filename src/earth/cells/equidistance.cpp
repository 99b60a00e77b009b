#include "earth/cells/equidistance.h"

#include <algorithm>
#include <cmath>

#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

// These are in metres.
constexpr double longest_step = 2e6;
constexpr double antipodal = 1.99e7;  // the antipode is 20,004 km away by the geodesic

/// Moves from p along the great circle of a tangent, by the tangent's length in radians.
Direction moved_on_sphere(Direction p, Direction tangent) {
  constexpr double straight = 1e-5;  // the third power of it does not count
  const double angle = length(tangent);
  if (angle <= straight) return unit(p + tangent);
  if (angle <= small_angle)
    return unit(small_cosine(angle) * p + (small_sine(angle) / angle) * tangent);
  return unit(std::cos(angle) * p + (std::sin(angle) / angle) * tangent);
}

/// A place, and the sphere's scale there.
struct Site {
  const EarthPoint& place;
  double scale;
};

/// As sphere_arrival; the scale at `at` is looked up once for all sites.
SphereArrival site_arrival(const Site& site, Direction at, double scale_there, double accuracy) {
  const Direction chord = at - site.place.direction;
  const double half = length(chord) / 2;
  if (half == 0 || !is_short_path(half, accuracy)) return sphere_arrival(site.place, at, accuracy);
  // The chord of two points of the unit sphere has 2 half^2 along each of them. The series for the
  // cosine of half the angle is right to 1e-14 where the path is short.
  const double square = half * half;
  const double along = 2 * square;
  const double size = 2 * half * (1 - square * (1. / 2 + square * (1. / 8 + square / 16)));
  return {short_path(sphere_scale(), {site.place.direction, site.scale}, {at, scale_there}, half),
          (1 / size) * (chord - along * at)};
}

}  // namespace

std::optional<Equidistant> equidistant_point(const EarthPoint& a, const EarthPoint& b,
                                             const EarthPoint& c, Direction start,
                                             double accuracy) {
  const auto scale = [](const EarthPoint& place) { return scale_on_earth(place.direction.z); };
  return equidistant_point({a, b, c}, {scale(a), scale(b), scale(c)}, start, accuracy);
}

std::optional<Equidistant> equidistant_point(const std::array<EarthPoint, 3>& places,
                                             const std::array<double, 3>& scales, Direction start,
                                             double accuracy) {
  const Site a{places[0], scales[0]};
  const Site b{places[1], scales[1]};
  const Site c{places[2], scales[2]};
  constexpr int most_steps = 20;
  Direction p = start;
  double before = HUGE_VAL;
  for (int i = 0; i < most_steps; ++i) {
    const double scale = scale_on_earth(p.z);
    const SphereArrival from_a = site_arrival(a, p, scale, accuracy);
    const SphereArrival from_b = site_arrival(b, p, scale, accuracy);
    const SphereArrival from_c = site_arrival(c, p, scale, accuracy);
    const double ab = from_a.distance - from_b.distance;
    const double ac = from_a.distance - from_c.distance;
    const double wrong = std::max(std::abs(ab), std::abs(ac));
    const Equidistant here{p, from_a.distance};
    if (wrong <= accuracy / 2) return here;
    if (i > 3 && wrong > before / 2) return wrong <= accuracy ? std::optional(here) : std::nullopt;
    before = wrong;
    // The step is the tangent, in metres, along which the differences of the distances vanish.
    const Direction u = from_a.onward - from_b.onward;
    const Direction v = from_a.onward - from_c.onward;
    const double determinant = dot(p, cross(u, v));
    const Direction step = (1 / determinant) * (-ab * cross(v, p) + ac * cross(u, p));
    const double size = length(step);
    if (!(size <= longest_step)) return {};
    p = moved_on_sphere(p, (1 / scale) * step);
    // The error that a step leaves is of the second order in the step.
    const double nearest = std::min({from_a.distance, from_b.distance, from_c.distance});
    if (size * size <= accuracy / 20 * nearest && from_a.distance < antipodal)
      return Equidistant{p, from_a.distance + dot(from_a.onward, step)};
  }
  return {};
}

}  // namespace thiessen

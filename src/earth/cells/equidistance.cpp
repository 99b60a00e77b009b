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
  const double angle = length(tangent);
  if (angle == 0) return p;
  return unit(std::cos(angle) * p + (std::sin(angle) / angle) * tangent);
}

}  // namespace

std::optional<Equidistant> equidistant_point(const EarthPoint& a, const EarthPoint& b,
                                             const EarthPoint& c, Direction start,
                                             double accuracy) {
  constexpr int most_steps = 20;
  Direction p = start;
  double before = HUGE_VAL;
  for (int i = 0; i < most_steps; ++i) {
    const SphereArrival from_a = sphere_arrival(a, p, accuracy);
    const SphereArrival from_b = sphere_arrival(b, p, accuracy);
    const SphereArrival from_c = sphere_arrival(c, p, accuracy);
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
    p = moved_on_sphere(p, (1 / scale_on_earth(p.z)) * step);
    // The error that a step leaves is of the second order in the step.
    const double nearest = std::min({from_a.distance, from_b.distance, from_c.distance});
    if (size * size <= accuracy / 20 * nearest && from_a.distance < antipodal)
      return Equidistant{p, from_a.distance + dot(from_a.onward, step)};
  }
  return {};
}

}  // namespace thiessen

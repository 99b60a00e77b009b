#include "earth/equidistance.h"

#include <algorithm>
#include <cmath>

#include "earth/geodesic.h"

namespace thiessen {
namespace {

// Metres.
constexpr double longest_step = 2e6;
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

std::optional<Equidistant> equidistant_point(const EarthPoint& a, const EarthPoint& b,
                                             const EarthPoint& c, Point start, double accuracy) {
  constexpr int most_steps = 20;
  Point p = start;
  double before = HUGE_VAL;
  for (int i = 0; i < most_steps; ++i) {
    const EarthPoint at(p);
    const Arrival from_a = arrival(a, at, accuracy);
    const Arrival from_b = arrival(b, at, accuracy);
    const Arrival from_c = arrival(c, at, accuracy);
    const double ab = from_a.distance - from_b.distance;
    const double ac = from_a.distance - from_c.distance;
    const double wrong = std::max(std::abs(ab), std::abs(ac));
    const Equidistant here{p, from_a.distance};
    if (wrong <= accuracy / 2) return here;
    if (i > 3 && wrong > before / 2) return wrong <= accuracy ? std::optional(here) : std::nullopt;
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
    if (step.length() * step.length() <= accuracy / 20 * nearest && from_a.distance < antipodal)
      return Equidistant{p, from_a.distance + from_a.east * step.east + from_a.north * step.north};
  }
  return {};
}

}  // namespace thiessen

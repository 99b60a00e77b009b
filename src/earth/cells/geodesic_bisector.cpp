#include "earth/cells/geodesic_bisector.h"

#include <algorithm>
#include <cmath>

#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/geodesic.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

// These are in metres.
constexpr double distance_noise = 3e-8;
constexpr double farthest = 60e3;
constexpr double antipodal = 1.99e7;  // the antipode is 20,004 km away by the geodesic
// This is in radians, and stands for 1e-5 metres.
constexpr double fine_offset = 1.6e-12;

struct Sample {
  double at;
  double value;
};

/// The point where the function changes its sign, to fine_offset. It is found by secants that halve
/// the value at an end that stays (M. Dowell and P. Jarratt, the Illinois algorithm, 1971), and by
/// bisection where they are slow.
template <typename Function>
double change_of_sign(Sample low, Sample high, Function&& function) {
  constexpr int most_secants = 30;
  for (int i = 0; std::abs(high.at - low.at) > fine_offset; ++i) {
    const double secant = high.at - high.value * (high.at - low.at) / (high.value - low.value);
    const double half = low.at + (high.at - low.at) / 2;
    const double at = i < most_secants && std::isfinite(secant) ? secant : half;
    const Sample sample{at, function(at)};
    if (sample.value == 0) return at;
    if (std::signbit(sample.value) != std::signbit(high.value)) {
      low = high;
    } else {
      low.value /= 2;
    }
    high = sample;
  }
  return high.at;
}

}  // namespace

BisectorPoint GeodesicBisector::find(double angle, double offset) const {
  if (const auto found = by_newton(angle, offset)) return *found;
  const double by_sign = by_bracket(angle).value_or(0);
  // Within some 100 km round the antipode, the difference of the distances from both places changes
  // by as much as the places are apart.
  constexpr double far_side = 1e5;  // metres
  const double uncertainty =
      distance_noise * far_side / (2 * arc_.half_separation() * mean_radius * mean_radius);
  return {by_sign, at(angle, by_sign), false, uncertainty};
}

// The sphere measures a distance d wrong by up to 0.34 % of d, but nearly as much for the one place
// as for the other. A twentieth of that is seen in the end.
double GeodesicBisector::farthest_off(double angle) const {
  constexpr double share = 0.01;
  constexpr double rounding = 1e-9;
  return share * (std::abs(angle) + arc_.half_separation()) + rounding;
}

Point GeodesicBisector::at(double angle, double offset) const {
  return from_sphere(arc_.at(angle, offset));
}

double GeodesicBisector::nearer_to_second(Point p) const {
  return geodesic_distance(first_.position, p) - geodesic_distance(second_.position, p);
}

std::optional<BisectorPoint> GeodesicBisector::by_newton(double angle, double offset) const {
  constexpr int most_steps = 8;
  for (int i = 0; i < most_steps; ++i) {
    const EarthPoint here(arc_.at(angle, offset));
    const Arrival from_first = arrival(first_, here, accuracy_);
    const Arrival from_second = arrival(second_, here, accuracy_);
    if (from_first.distance > antipodal) return {};
    const double difference = from_first.distance - from_second.distance;
    const Tangent across = tangent_at(here.direction, arc_.across(angle, offset));
    const double growth = (from_first.east - from_second.east) * across.east +
                          (from_first.north - from_second.north) * across.north;
    const double scale = scale_on_earth(here.direction.z);
    const double step = -difference / (growth * scale);
    if (!(growth > 0) || !(std::abs(offset + step) * mean_radius <= farthest)) return {};
    const double uncertainty = distance_noise / (growth * scale);
    if (std::abs(difference) <= distance_noise)
      return BisectorPoint{offset, here.position, true, uncertainty};
    offset += step;
    // The error that is left is of the second order in the step.
    const double length = step * scale;
    if (length * length <= accuracy_ * growth * from_first.distance)
      return BisectorPoint{offset, at(angle, offset), true, uncertainty};
  }
  return {};
}

// Searches on either side of the great circle, ever farther out, until the difference changes its
// sign.
std::optional<double> GeodesicBisector::by_bracket(double angle) const {
  constexpr double first_reach = 500 / mean_radius;
  constexpr double last_reach = 200e3 / mean_radius;
  const auto sample_at = [&](double offset) {
    return Sample{offset, nearer_to_second(at(angle, offset))};
  };
  const Sample middle = sample_at(0);
  if (middle.value == 0) return 0;
  for (double reach = first_reach; reach <= last_reach; reach *= 2) {
    for (const double offset : {reach, -reach}) {
      const Sample end = sample_at(offset);
      if (std::signbit(end.value) == std::signbit(middle.value) && end.value != 0) continue;
      return change_of_sign(middle, end, [&](double at) { return sample_at(at).value; });
    }
  }
  return {};
}

}  // namespace thiessen

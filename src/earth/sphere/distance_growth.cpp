// Bounds on how fast the distances from two places may grow apart, or together, around a point.
//
// Along a geodesic the distance s from a place changes by the cosine of the angle between the
// geodesic and the direction u of arrival. Its second derivative is h times the square of the sine
// of that angle, where h is the curvature of the circle round the place. The ellipsoid's curvature
// lies between 1 / R^2 and 1 / b^2, where R = a^2 / b, so by the Hessian comparison theorem h lies
// between cot(s / b) / b and cot(s / R) / R up to s = pi b; no point nearer than that has two
// shortest paths. The functions below bound the second derivative of the difference of two
// distances from below: by either curvature itself, or, where the places are near each other, by
// the difference of both. There h varies little between the places, and so do the directions,
// because u turns by h at most along the way.
#include <GeographicLib/Constants.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

struct Radii {
  double polar = GeographicLib::Constants::WGS84_a() * (1 - GeographicLib::Constants::WGS84_f());
  double largest = GeographicLib::Constants::WGS84_a() / (1 - GeographicLib::Constants::WGS84_f());
};

const Radii& radii() {
  static const Radii of_the_earth;
  return of_the_earth;
}

// The largest curvature that a circle of radius s may have on the ellipsoid; it falls as s grows.
double most_curved(double s) {
  return s > 0 ? 1 / (radii().largest * std::tan(s / radii().largest)) : HUGE_VAL;
}
/// The smallest curvature that a circle of radius s may have on the ellipsoid; it falls as s grows.
double least_curved(double s) {
  const double polar = radii().polar;
  return s / polar < std::numbers::pi ? 1 / (polar * std::tan(s / polar)) : -HUGE_VAL;
}

/// The absolute value of the second derivative's lower bound, whether or not the places are near
/// each other.
double most_bent(double first, double second, double reach) {
  return std::max(0.0, most_curved(first - reach)) + std::max(0.0, -least_curved(second + reach));
}

/// The absolute value of the second derivative's lower bound for places near each other, whose
/// distances lie between `nearest` and `farthest` and differ by `apart` at most.
double most_bent_together(double nearest, double farthest, double apart, double turned,
                          double reach) {
  const auto falls = [&](double s) { return least_curved(s) - least_curved(s + apart); };
  const double differ =
      most_curved(farthest) - least_curved(farthest) + std::max(falls(nearest), falls(farthest));
  const double curved = std::max(most_curved(nearest), -least_curved(farthest));
  const double turned_at_most = (turned + differ * reach) * std::exp(2 * curved * reach);
  return differ + 2 * curved * turned_at_most;
}

}  // namespace

double least_difference(const Arrival& first, const Arrival& second, double apart, double reach) {
  const double turned = std::hypot(second.east - first.east, second.north - first.north);
  double lost =
      turned * reach + most_bent(first.distance, second.distance, reach) * reach * reach / 2;
  const double nearest = std::min(first.distance, second.distance) - reach;
  const double farthest = std::max(first.distance, second.distance) + reach;
  if (nearest > 0 && farthest + apart < std::numbers::pi * radii().polar) {
    const double bent = most_bent_together(nearest, farthest, apart, turned, reach);
    lost = std::min(lost, turned * reach + bent * reach * reach / 2);
  }
  return second.distance - first.distance - std::min(2 * reach, lost);
}

}  // namespace thiessen

// How the distances from two places may grow apart, or together, around a point.
//
// Along a geodesic the distance s from a place changes by the cosine of the angle between it and
// the direction u of arrival, and its second derivative is h times the square of the sine, where h
// is the curvature of the circle round the place. By the Hessian comparison theorem h is between
// cot(s / b) / b and cot(s / R) / R up to s = pi b, for the ellipsoid's curvature is between 1 /
// R^2 and 1 / b^2 (R = a^2 / b), and nobody has two shortest ways nearer than that. What follows
// bounds the second derivative of the difference of two distances from below, by either curvature
// itself, or where the places are near each other by the difference of both: h varies little
// between them, and so do the directions, for along the way u turns by h at most.
#include <GeographicLib/Constants.hpp>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "earth/geodesic.h"

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

// The curvature of a circle of radius s, which falls as s grows.
double most_curved(double s) {
  return s > 0 ? 1 / (radii().largest * std::tan(s / radii().largest)) : HUGE_VAL;
}
double least_curved(double s) {
  const double polar = radii().polar;
  return s / polar < std::numbers::pi ? 1 / (polar * std::tan(s / polar)) : -HUGE_VAL;
}

/// The second derivative's lower bound, by its absolute value, without regard to how near the
/// places are to each other.
double most_bent(double first, double second, double reach) {
  return std::max(0.0, most_curved(first - reach)) + std::max(0.0, -least_curved(second + reach));
}

/// The same for places near each other, at distances from `nearest` to `farthest` and no more than
/// `apart` different.
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

#include "earth/sphere/chord_bounds.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Math.hpp>
#include <limits>

namespace thiessen {
namespace {

using GeographicLib::Math;

struct Ellipsoid {
  double a = GeographicLib::Constants::WGS84_a();
  double f = GeographicLib::Constants::WGS84_f();
  double b = a * (1 - f);
  double square_of_eccentricity = f * (2 - f);
  double largest_radius = a * a / b;
  double smallest_radius = b * b / a;
  /// A length that no geodesic exceeds: half a meridian, rounded up.
  double farthest = 20003932;
};

const Ellipsoid& earth() {
  static const Ellipsoid ellipsoid;
  return ellipsoid;
}

}  // namespace

Direction on_ellipsoid(Point position) {
  double east = 0;
  double outward = 0;
  double north = 0;
  double level = 0;
  Math::sincosd(position.x, east, outward);
  Math::sincosd(position.y, north, level);
  const double e2 = earth().square_of_eccentricity;
  const double normal = earth().a / std::sqrt(1 - e2 * north * north);
  return {normal * level * outward, normal * level * east, normal * (1 - e2) * north};
}

FootPoint below(Direction at) {
  FootPoint foot{};
  GeographicLib::Geocentric::WGS84().Reverse(at.x, at.y, at.z, foot.position.y, foot.position.x,
                                             foot.height);
  foot.height = std::abs(foot.height);
  return foot;
}

double longest_over_chord(double chord) {
  const double diameter = 2 * earth().smallest_radius;
  return chord < diameter ? diameter * std::asin(chord / diameter) : earth().farthest;
}

double least_certain_excess(double chord) {
  constexpr double short_chord = 1e6;
  if (chord <= short_chord) return 4.5e-17 * chord * chord * chord * chord;
  const double diameter = 2 * earth().largest_radius;
  if (chord >= 2 * earth().smallest_radius) return std::numeric_limits<double>::infinity();
  const double reach = diameter * std::sin(longest_over_chord(chord) / diameter);
  const double rounding = 1e-13 * chord * chord;
  return reach * reach - chord * chord + rounding;
}

// Proof of the bound. Let X be the straight vector from a point to a place, S the length of the arc
// over it of a circle of the mean radius of curvature R, s the length of the geodesic, and D the
// most by which its curvature, and its torsion, may differ from the circle's. Along the geodesic,
// whose trihedron T, V, N turns by curvature and torsion, X.N differs from that of the circle by D
// s^2 / 2 at most, and X.V by D s^3 / 6R. So the gradients of s and S by the place differ by no
// more than D s^2 / R times 0.32 / (1 - (X / 2R)^2), as long as s is a quarter of a turn or less.
// On the way from one place to another s - S therefore changes by no more than that bound times the
// length of the way.
double least_certain_excess_apiece(double chord) {
  static const double most = 1 / earth().smallest_radius;
  static const double least = 1 / earth().largest_radius;
  static const double radius = 2 / (most + least);
  // These are bounds, as multiples of `chord`, on the chords of the places and of all points
  // between them, and on twice their mean.
  constexpr double longest_chord = 1.15;
  constexpr double twice_mean = 1.07;
  const double longest = longest_chord * chord;
  if (longest > std::sqrt(2.0) * 0.999 * radius) return std::numeric_limits<double>::infinity();
  const double geodesic = longest_over_chord(longest);
  const double half = longest / (2 * radius);
  const double gradients_differ =
      0.32 * (most - least) / 2 / radius * geodesic * geodesic / (1 - half * half);
  return twice_mean * gradients_differ * chord;
}

}  // namespace thiessen

#include "earth/cells/short_edge.h"

#include <GeographicLib/Constants.hpp>
#include <algorithm>
#include <cmath>

#include "earth/area/ellipsoid_area.h"
#include "earth/sphere/conformal_sphere.h"
#include "earth/sphere/units.h"

// How a short edge runs, and how far it may be off.
//
// Next to the places it is a geodesic. On the conformal sphere, beside the great circle of two
// places that are an angle of 2h apart, let t be the angle along the circle, and g(t) the growth
// across it of the logarithm of the scale k, by an angle. Of the paths from the places to a point
// of the circle the one is longer by what ln k has more on its side: its way across is 2h (1 - x)
// wide at a share x of the length l, where the growth is g(xt), so that to the first order it is
// longer by 2h l times the integral of (1 - x) g(xt), or h l (g(0) + t g'/3 + t^2 g''/12). A step
// across the circle changes the difference by 2h / l of its length. So the bisector lies off the
// circle by o(t) = (h^2 + t^2) (g(0) + t g'/3 + t^2 g''/12) / 2, which bends by
// o'' = g(0) + t g' + t^2 g''/2 + h^2 g''/12. A geodesic bends by g(t), which is the same but for
// the last term; the growth of g across the circle adds one more of that size. Both g'' are 0.0136
// at most. So between its ends the edge is off the geodesic by s^2 / 8 times h^2 / 6 times that,
// where s is its length: 4e-13 radians, or 3e-6 metres, for h of 0.01 and s of 0.004. g itself is
// 0.0034 at most, and what is of the second order in it is less than this.
//
// The geodesic's longitude and latitude have their second and third derivatives by the share of the
// length from its differential equation, at the middle. Of the fourth derivative 1/384 counts at
// most: on a sphere it is below 24 / cos^3 of the latitude, times s^4, on the ground. Where that is
// more than 2e-6 metres, it is told by the second derivatives at both ends. Of the fifth 1/7000
// counts, below 120 / cos^4 times s^5 on the ground: 2e-6 metres for s of 0.007 cos.

namespace thiessen {
namespace {

constexpr double shortest = 1e-8;       // radians
constexpr double farthest = 0.01;       // from the places
constexpr double least_fourth = 1e-10;  // 1/384 of it is 2e-6 metres
constexpr double longest_of_cosine = 0.007;

struct Latitude {
  double sine;
  double cosine;
};
/// A latitude by another one that is less than 0.004 away.
Latitude moved(const Latitude& from, double way) {
  const double square = way * way / 2;
  const double odd = way * (1 - square / 3);
  return {from.sine * (1 - square) + from.cosine * odd,
          from.cosine * (1 - square) - from.sine * odd};
}

struct Ellipsoid {
  double square = GeographicLib::Constants::WGS84_f() * (2 - GeographicLib::Constants::WGS84_f());
  double rest = 1 - square;
};
const Ellipsoid& ellipsoid() {
  static const Ellipsoid wgs84;
  return wgs84;
}

double square_distance(Direction a, Direction b) {
  return dot(a - b, a - b);
}

/// How geodesics run at a latitude. With dashes for derivatives by the share of the length,
/// longitude'' = 2 east longitude' latitude' and
/// latitude'' = -north longitude'^2 - meridian latitude'^2.
class GeodesicEquation {
 public:
  explicit GeodesicEquation(const Latitude& latitude) {
    const auto [sine, cosine] = latitude;
    const auto [e2, rest] = ellipsoid();
    const double narrowing = 1 - e2 * sine * sine;
    const double inverse = 1 / (cosine * narrowing);
    const double turning = 2 * e2 * sine * sine * cosine * cosine;
    const double double_cosine = (cosine - sine) * (cosine + sine);
    east_ = rest * sine * inverse;
    east_growth_ = rest * (narrowing + turning) * inverse * inverse;
    north_ = sine * cosine * narrowing / rest;
    north_growth_ = (double_cosine * narrowing - turning) / rest;
    meridian_ = 3 * e2 * sine * cosine * cosine * inverse;
    meridian_growth_ = 3 * e2 * double_cosine;
  }

  Point second(Point first) const {
    return {2 * east_ * first.x * first.y,
            -(north_ * first.x * first.x + meridian_ * first.y * first.y)};
  }
  Point third(Point first, Point second) const {
    const double x = first.x, y = first.y;
    return {2 * (east_growth_ * x * y * y + east_ * (second.x * y + x * second.y)),
            -(north_growth_ * y * x * x + 2 * north_ * x * second.x + meridian_growth_ * y * y * y +
              2 * meridian_ * y * second.y)};
  }

 private:
  double east_;
  double east_growth_;  // by the latitude
  double north_;
  double north_growth_;
  double meridian_;
  double meridian_growth_;
};

Point sum(Point a, double share, Point b) {
  return {a.x + share * b.x, a.y + share * b.y};
}

/// The fourth derivative of a geodesic by the share of its length, from its second ones at both
/// ends and in the middle.
Point fourth_derivative(const Latitude& middle, Point way, Point bend, Point twist) {
  const auto second_at = [&](double side) {
    const Point slope = sum(sum(way, 1. / 12, twist), side / 2, bend);
    return GeodesicEquation(moved(middle, side / 2 * way.y + bend.y / 8)).second(slope);
  };
  const Point start = second_at(-1);
  const Point end = second_at(1);
  return {4 * (start.x + end.x - 2 * bend.x), 4 * (start.y + end.y - 2 * bend.y)};
}

}  // namespace

std::optional<ShortEdge> ShortEdge::fit(Direction first, Direction second, const EdgeEnd& start,
                                        const EdgeEnd& end) {
  const Direction chord = end.direction - start.direction;
  const double square = dot(chord, chord);
  if (!(square >= shortest * shortest && square <= longest * longest)) return {};
  if (!(std::max(square_distance(start.direction, first), square_distance(end.direction, first)) <=
        farthest * farthest))
    return {};
  // Rounding may put the ends of an edge next to nothing the wrong way round.
  if (!(dot(chord, cross(start.direction, second - first)) > 0)) return {};
  // The middle of the chord lies so much below the sphere.
  const double conformal_sine = (start.direction.z + end.direction.z) / 2 * (1 + square / 8);
  const double sine = sine_of_latitude(conformal_sine);
  const double square_cosine = 1 - sine * sine;
  if (!(square <= longest_of_cosine * longest_of_cosine * square_cosine)) return {};
  const Latitude middle{sine, std::sqrt(square_cosine)};

  ShortEdge edge;
  edge.length_ = std::sqrt(square) * (1 + square / 24);
  edge.sine_ = middle.sine;
  edge.cosine_ = middle.cosine;
  edge.way_ = {end.position.x - start.position.x, end.position.y - start.position.y};
  edge.middle_ = sum(start.position, 0.5, edge.way_);
  const Point way{edge.way_.x * degree, edge.way_.y * degree};
  const GeodesicEquation geodesic(middle);
  const Point twist = geodesic.third(way, geodesic.second(way));
  const Point bend = geodesic.second(sum(way, -1. / 24, twist));
  if (24 * square * square > least_fourth * square_cosine * middle.cosine) {
    const Point fourth = fourth_derivative(middle, way, bend, twist);
    edge.fourth_ = {fourth.x / degree, fourth.y / degree};
  }
  // ln k grows by so much for the sine of the conformal latitude.
  const double growth = conformal_sine * (-0.0067387 + 0.000074 * conformal_sine * conformal_sine);
  edge.stretch_ = growth * chord.z / 2;
  edge.bend_ = {bend.x / degree, bend.y / degree};
  edge.twist_ = {twist.x / degree, twist.y / degree};
  return edge;
}

/// A piece of an edge, in degrees by the share of the whole.
struct ShortEdge::Piece {
  Point slope;
  Point curve;
  Latitude latitude;
};

ShortEdge::Piece ShortEdge::piece(double along, double part) const {
  const Point curve = sum(sum(bend_, along, twist_), along * along / 2 + part * part / 40, fourth_);
  return {sum(way_, along, bend_), curve, moved({sine_, cosine_}, along * way_.y * degree)};
}

// Of the fourth derivative 1/48 of the part's square counts at the middle, which 1/40 is near to.
ShortEdge::Bend ShortEdge::bend() const {
  const auto off_chord = [&](double along, double part) {
    const auto [slope, curve, latitude] = piece(along, part);
    const double east = slope.x * latitude.cosine;
    const double length = std::sqrt(east * east + slope.y * slope.y);
    if (length == 0) return 0.0;
    const double across = (east * curve.y - slope.y * curve.x * latitude.cosine) / length;
    return across * part * part / 8 * degree * mean_radius;
  };
  return {off_chord(0, 1), off_chord(-0.25, 0.5), off_chord(0.25, 0.5)};
}

double ShortEdge::area_beside_chord(double middle, double part) const {
  const auto [slope, curve, latitude] = piece(middle - 0.5, part);
  const double turn = slope.x * curve.y - slope.y * curve.x;
  return turn * degree * degree * part * part * part / 12 *
         square_radian(latitude.sine, latitude.cosine);
}

}  // namespace thiessen

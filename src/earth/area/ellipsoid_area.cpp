#include "earth/area/ellipsoid_area.h"

#include <GeographicLib/Constants.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "earth/sphere/small_angles.h"
#include "earth/sphere/units.h"

namespace thiessen {
namespace {

struct Wgs84 {
  double equatorial_radius = GeographicLib::Constants::WGS84_a();
  double flattening = GeographicLib::Constants::WGS84_f();
  double polar_radius = equatorial_radius * (1 - flattening);
  double square_eccentricity = flattening * (2 - flattening);
  double eccentricity = std::sqrt(square_eccentricity);
};

const Wgs84& wgs84() {
  static const Wgs84 ellipsoid;
  return ellipsoid;
}

/// The area of a strip one radian wide between two parallels, in square metres.
class Strip {
 public:
  explicit Strip(double reference)
      : reference_(reference),
        sine_(std::sin(reference)),
        cosine_(std::cos(reference)),
        narrowing_(1 - ellipsoid_.square_eccentricity * sine_ * sine_) {}

  double up_to(double latitude) const { return up_to(sines_at(latitude)); }

  /// The mean of the areas up to the latitudes of a segment, for one that rises by no more than
  /// longest_for_one_point: that up to its middle, and the second term of the series about it. The
  /// third is below rise^4 / 1920 of the Earth's radius squared.
  double mean(double middle, double rise) const {
    const Wgs84& e = ellipsoid_;
    const Sines there = sines_at(middle);
    const double square = there.sine * there.sine;
    const double narrowing = 1 - e.square_eccentricity * square;
    const double bend = there.sine * (4 * e.square_eccentricity * (1 - square) - narrowing) /
                        (narrowing * narrowing * narrowing);
    return up_to(there) + e.polar_radius * e.polar_radius * bend * rise * rise / 24;
  }

 private:
  /// The sine of a latitude, and what it is more than the reference's.
  struct Sines {
    double sine;
    double rise;
  };

  Sines sines_at(double latitude) const {
    const double half = (latitude - reference_) / 2;
    if (std::abs(half) > small_angle) {
      return {std::sin(latitude), 2 * std::sin(half) * std::cos((latitude + reference_) / 2)};
    }
    const double sine = small_sine(half);
    const double rise = 2 * sine * (cosine_ * small_cosine(half) - sine_ * sine);
    return {sine_ + rise, rise};
  }

  double up_to(const Sines& there) const {
    const Wgs84& e = ellipsoid_;
    const auto [sine, rise] = there;
    const double product = e.square_eccentricity * sine * sine_;
    const double rational =
        rise * (1 + product) / ((1 - e.square_eccentricity * sine * sine) * narrowing_);
    const double transcendental =
        area_tangent(e.eccentricity * rise / (1 - product)) / e.eccentricity;
    return e.polar_radius * e.polar_radius / 2 * (rational + transcendental);
  }

  /// The inverse of the hyperbolic tangent. The first term that the series leaves out is below
  /// 2e-17 of the result.
  static double area_tangent(double t) {
    if (std::abs(t) > 0.01) return std::atanh(t);
    const double s = t * t;
    return t + t * s * (1. / 3 + s * (1. / 5 + s * (1. / 7)));
  }

  const Wgs84& ellipsoid_ = wgs84();
  double reference_;
  double sine_;
  double cosine_;
  double narrowing_;
};

struct Abscissa {
  double offset;  // from the middle, in half lengths
  double weight;
};
constexpr std::array<Abscissa, 2> two_points{{{-0.5773502691896257, 1}, {0.5773502691896257, 1}}};
constexpr std::array<Abscissa, 4> four_points{{{-0.8611363115940526, 0.34785484513745386},
                                               {-0.3399810435848563, 0.6521451548625461},
                                               {0.3399810435848563, 0.6521451548625461},
                                               {0.8611363115940526, 0.34785484513745386}}};
constexpr double longest_for_one_point = 1e-3;  // radians
// The Gauss-Legendre rules are right to 4e-15 of the Earth's radius squared for segments that rise
// by no more than this, in radians.
constexpr double longest_for_two_points = 2e-3;
constexpr double longest_for_four_points = 2 * degree;

template <std::size_t N>
double mean_strip(const Strip& strip, double middle, double half,
                  const std::array<Abscissa, N>& rule) {
  double sum = 0;
  for (const Abscissa& x : rule) sum += x.weight * strip.up_to(middle + x.offset * half);
  return sum / 2;
}

/// The area under a segment that does not run to the west.
double area_in(const Strip& strip, Point a, Point b) {
  const double width = (b.x - a.x) * degree;
  if (width == 0) return 0;
  const double south = a.y * degree;
  const double rise = (b.y - a.y) * degree;
  if (std::abs(rise) <= longest_for_one_point) return width * strip.mean(south + rise / 2, rise);
  if (std::abs(rise) <= longest_for_two_points) {
    return width * mean_strip(strip, south + rise / 2, rise / 2, two_points);
  }
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(rise) / longest_for_four_points)));
  const double half = rise / (2 * pieces);
  double sum = 0;
  for (int piece = 0; piece < pieces; ++piece) {
    sum += mean_strip(strip, south + half * (2 * piece + 1), half, four_points);
  }
  return width * sum / pieces;
}

double signed_area_in(const Strip& strip, Point a, Point b) {
  return b < a ? -area_in(strip, b, a) : area_in(strip, a, b);
}

}  // namespace

double area_under(Point a, Point b, double reference_latitude) {
  return signed_area_in(Strip(reference_latitude * degree), a, b);
}

void areas_under(std::span<const Segment> segments, double reference_latitude,
                 std::vector<double>& areas) {
  const Strip strip(reference_latitude * degree);
  areas.resize(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i)
    areas[i] = signed_area_in(strip, segments[i].from, segments[i].to);
}

double area_beside_chord(Point start, Point middle, Point end) {
  const auto east = [&](Point p) {
    const double way = p.x - start.x;
    return (std::abs(way) <= 180 ? way : std::remainder(way, 360)) * degree;
  };
  const auto north = [&](Point p) { return (p.y - start.y) * degree; };
  const double sagitta =
      east(end) * (north(middle) - north(end) / 2) - north(end) * (east(middle) - east(end) / 2);
  return -2.0 / 3 * sagitta *
         square_radian(std::sin(middle.y * degree), std::cos(middle.y * degree));
}

double square_radian(double sine, double cosine) {
  const Wgs84& e = wgs84();
  const double narrowing = 1 - e.square_eccentricity * sine * sine;
  return e.polar_radius * e.polar_radius * cosine / (narrowing * narrowing);
}

}  // namespace thiessen

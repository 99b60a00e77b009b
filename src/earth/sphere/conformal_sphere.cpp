#include "earth/sphere/conformal_sphere.h"

#include <GeographicLib/Constants.hpp>
#include <GeographicLib/Math.hpp>
#include <array>
#include <initializer_list>
#include <numbers>

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

double third_flattening() {
  const double f = GeographicLib::Constants::WGS84_f();
  return f / (2 - f);
}

/// A series in sines of multiples of one latitude that gives the difference between the geographic
/// and the conformal latitude, either way. It goes to the sixth power of the third flattening; the
/// terms left out are below 1e-18.
class LatitudeSeries {
 public:
  /// terms[k] are the coefficients of n^(k+1), n^(k+2) and so on in the factor of sin(2(k+1) x),
  /// where n is the third flattening.
  LatitudeSeries(std::initializer_list<std::initializer_list<double>> terms) {
    const double n = third_flattening();
    std::size_t k = 0;
    for (const auto& polynomial : terms) {
      double factor = std::pow(n, static_cast<double>(k + 1));
      for (const double coefficient : polynomial) {
        terms_[k] += coefficient * factor;
        factor *= n;
      }
      ++k;
    }
  }
  /// The sum at the latitude whose sine and cosine are given, by Clenshaw's method.
  double at(double sine, double cosine) const {
    const double sine_of_double = 2 * sine * cosine;
    const double twice_cosine_of_double = 2 * (cosine - sine) * (cosine + sine);
    double before = 0;
    double sum = 0;
    for (std::size_t i = terms_.size(); i-- > 0;) {
      const double next = twice_cosine_of_double * sum - before + terms_[i];
      before = sum;
      sum = next;
    }
    return sine_of_double * sum;
  }
  /// The sum at middle + step / 2 minus the sum at middle - step / 2, without cancellation.
  double difference(double middle, double step) const {
    double sum = 0;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const double multiple = 2 * static_cast<double>(i + 1);
      sum += 2 * terms_[i] * std::cos(multiple * middle) * std::sin(multiple * step / 2);
    }
    return sum;
  }

 private:
  std::array<double, 6> terms_{};
};

const LatitudeSeries& latitude_series() {
  static const LatitudeSeries series{{2, -2. / 3, -2, 116. / 45, 26. / 45, -2854. / 675},
                                     {7. / 3, -8. / 5, -227. / 45, 2704. / 315, 2323. / 945},
                                     {56. / 15, -136. / 35, -1262. / 105, 73814. / 2835},
                                     {4279. / 630, -332. / 35, -399572. / 14175},
                                     {4174. / 315, -144838. / 6237},
                                     {601676. / 22275}};
  return series;
}

const LatitudeSeries& conformal_series() {
  static const LatitudeSeries series{{-2, 2. / 3, 4. / 3, -82. / 45, 32. / 45, 4642. / 4725},
                                     {5. / 3, -16. / 15, -13. / 9, 904. / 315, -1522. / 945},
                                     {-26. / 15, 34. / 21, 8. / 5, -12686. / 2835},
                                     {1237. / 630, -12. / 5, -24832. / 14175},
                                     {-734. / 315, 109598. / 31185},
                                     {444337. / 155925}};
  return series;
}

/// The scale of the conformal map as a polynomial in the square of the sine of the conformal
/// latitude, by Newton's interpolation.
class SphereScale {
 public:
  SphereScale() {
    const double a = GeographicLib::Constants::WGS84_a();
    const double e2 =
        GeographicLib::Constants::WGS84_f() * (2 - GeographicLib::Constants::WGS84_f());
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      // Chebyshev's nodes leave out the pole itself, where the quotient below would be 0 / 0.
      const double turn =
          (2 * static_cast<double>(i) + 1) / (2 * static_cast<double>(nodes_.size()));
      nodes_[i] = 0.5 - 0.5 * std::cos(turn * std::numbers::pi);
      const double cosine = std::sqrt(1 - nodes_[i]);
      double sine_here = 0;
      double cosine_here = 0;
      Math::sincosd(from_sphere({cosine, 0, std::sqrt(nodes_[i])}).y, sine_here, cosine_here);
      double difference = a * cosine_here / (std::sqrt(1 - e2 * sine_here * sine_here) * cosine);
      for (std::size_t k = 0; k < i; ++k)
        difference = (difference - differences_[k]) / (nodes_[i] - nodes_[k]);
      differences_[i] = difference;
    }
  }
  double at(double sine) const {
    const double square = sine * sine;
    double scale = 0;
    for (std::size_t i = nodes_.size(); i-- > 0;)
      scale = differences_[i] + (square - nodes_[i]) * scale;
    return scale;
  }

 private:
  std::array<double, 7> nodes_{};
  std::array<double, 7> differences_{};
};

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
  static const SphereScale scale;
  return scale.at(sine);
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

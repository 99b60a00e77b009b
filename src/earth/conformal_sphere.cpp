#include "earth/conformal_sphere.h"

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

/// The series of the latitude in multiples of the conformal latitude, to the sixth power of the
/// third flattening; what follows is below 1e-18.
class LatitudeSeries {
 public:
  LatitudeSeries() {
    const double f = GeographicLib::Constants::WGS84_f();
    const double n = f / (2 - f);
    const auto polynomial = [n](int power, std::initializer_list<double> terms) {
      double sum = 0;
      double factor = std::pow(n, power);
      for (const double term : terms) {
        sum += term * factor;
        factor *= n;
      }
      return sum;
    };
    terms_ = {polynomial(1, {2, -2. / 3, -2, 116. / 45, 26. / 45, -2854. / 675}),
              polynomial(2, {7. / 3, -8. / 5, -227. / 45, 2704. / 315, 2323. / 945}),
              polynomial(3, {56. / 15, -136. / 35, -1262. / 105, 73814. / 2835}),
              polynomial(4, {4279. / 630, -332. / 35, -399572. / 14175}),
              polynomial(5, {4174. / 315, -144838. / 6237}),
              polynomial(6, {601676. / 22275})};
  }
  /// What to add to the conformal latitude, in radians, by Clenshaw's summation.
  double correction(double sine, double cosine) const {
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

 private:
  std::array<double, 6> terms_;
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

Point from_sphere(Direction direction) {
  static const LatitudeSeries series;
  constexpr double degrees = 180 / std::numbers::pi;
  const double square = direction.x * direction.x + direction.y * direction.y;
  if (square == 0) return {0, direction.z > 0 ? 90.0 : -90.0};
  const double radius = std::sqrt(square);
  const double size = std::sqrt(square + direction.z * direction.z);
  const double latitude =
      std::atan2(direction.z, radius) + series.correction(direction.z / size, radius / size);
  return {Math::atan2d(direction.y, direction.x), latitude * degrees};
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

}  // namespace thiessen

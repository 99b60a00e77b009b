#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/determinants.h"
#include "geometry/point.h"

namespace thiessen {

/// The value of a polynomial in doubles, with the means to bound its rounding error: `magnitude` is
/// the sum of the magnitudes of its terms, computed the same way.
///
/// The error of the value is at most a multiple of the magnitude. Let u = 2^-53. A term that goes
/// through k roundings, on the longest way from a coordinate to the last step of the sum, changes
/// by (1 + u)^k - 1 of itself at most, and the last step itself never changes the sign. So a value
/// that is at least (k u + O(u^2)) times the magnitude has the right sign. Where all terms are
/// zero, as among points along an axis, the value is zero for certain.
///
/// Requires that nothing underflows: see the exact range of predicates.h.
struct Estimate {
  double value;
  double magnitude;

  /// Whether the sign of the value is certain, for terms that go through this many roundings.
  template <int Roundings>
  bool is_certain_after() const {
    static_assert(Roundings <= 16);
    constexpr double u = 0x1p-53;
    // The 32 covers all errors of the order of u^2, and the roundings of the magnitude itself.
    constexpr double bound = Roundings * u * (1 + 32 * u);
    return std::abs(value) >= bound * magnitude;
  }
  /// Whether the value is exact. It is where all coordinates are whole multiples of a unit so large
  /// that the terms, products of Degree differences, add up to less than 2^53 in powers of that
  /// unit: then no rounding has changed anything. That is so on lattices of moderate size, where
  /// values are often zero.
  template <int Degree, class... Coordinates>
  bool is_exact_for(Coordinates... coordinates) const {
    // The magnitude is below 2^(exponent + 1), and the exponent of the unit is (exponent - 52) /
    // Degree, rounded up.
    const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52);
    const int unit = (biased - 1075 + Degree * 1024 - 1) / Degree + 1 - 1024;
    // Adding 2^52 units and taking them away again rounds to multiples of the unit, because the
    // last digit of the sum is worth one unit or more.
    const double grid = std::bit_cast<double>(static_cast<std::uint64_t>(unit + 1075) << 52);
    const auto change = [grid](double coordinate) {
      const double size = std::abs(coordinate);
      return std::bit_cast<std::uint64_t>((size + grid) - grid) ^
             std::bit_cast<std::uint64_t>(size);
    };
    return (change(coordinates) | ...) == 0;
  }
  int sign() const { return static_cast<int>(value > 0) - static_cast<int>(value < 0); }

  static Estimate difference(double a, double b) {
    const double value = a - b;
    return {value, std::abs(value)};
  }
  friend Estimate operator+(const Estimate& a, const Estimate& b) {
    return {a.value + b.value, a.magnitude + b.magnitude};
  }
  friend Estimate operator-(const Estimate& a, const Estimate& b) {
    return {a.value - b.value, a.magnitude + b.magnitude};
  }
  friend Estimate operator*(const Estimate& a, const Estimate& b) {
    return {a.value * b.value, a.magnitude * b.magnitude};
  }
};

/// The vector from one point to another, with its rounding error estimated.
inline PlaneVector<Estimate> estimated_vector(const Point& from, const Point& to) {
  return {Estimate::difference(to.x, from.x), Estimate::difference(to.y, from.y)};
}
inline SpaceVector<Estimate> estimated_vector(const SpacePoint& from, const SpacePoint& to) {
  return {Estimate::difference(to.x, from.x), Estimate::difference(to.y, from.y),
          Estimate::difference(to.z, from.z)};
}

/// The in-circle determinant of a, b, c as seen from d.
inline Estimate estimated_lift(const Point& a, const Point& b, const Point& c, const Point& d) {
  return determinant::in_circle(estimated_vector(d, a), estimated_vector(d, b),
                                estimated_vector(d, c));
}

/// The in-sphere determinant of a, b, c, d as seen from e.
inline Estimate estimated_lift(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                               const SpacePoint& d, const SpacePoint& e) {
  return determinant::in_sphere(estimated_vector(e, a), estimated_vector(e, b),
                                estimated_vector(e, c), estimated_vector(e, d));
}

/// The in-sphere determinant of a, b, c, d as seen from e, with a larger magnitude than that of
/// estimated_lift, but for less work. The bound uses the largest differences along the axes: a
/// square is at most the square of these, the six terms of a volume are at most six times their
/// product, and there are four of each.
inline Estimate quick_lift(const SpacePoint& a, const SpacePoint& b, const SpacePoint& c,
                           const SpacePoint& d, const SpacePoint& e) {
  const auto from_e = [&e](const SpacePoint& p) {
    return SpaceVector<double>{p.x - e.x, p.y - e.y, p.z - e.z};
  };
  const auto largest = [](double p, double q, double r, double s) {
    return std::max(std::max(std::abs(p), std::abs(q)), std::max(std::abs(r), std::abs(s)));
  };
  const auto ea = from_e(a), eb = from_e(b), ec = from_e(c), ed = from_e(d);
  const SpaceVector<double> extent{largest(ea.x, eb.x, ec.x, ed.x), largest(ea.y, eb.y, ec.y, ed.y),
                                   largest(ea.z, eb.z, ec.z, ed.z)};
  return {determinant::in_sphere(ea, eb, ec, ed),
          24 * (extent.x * extent.y * extent.z) * determinant::square(extent)};
}

}  // namespace thiessen

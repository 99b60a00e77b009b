#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/determinants.h"
#include "geometry/point.h"

namespace thiessen {

/// A polynomial computed in doubles, beside the sum of its terms' magnitudes computed the same way.
/// What rounding has done to the value is at most a multiple of that sum, which the number of
/// roundings on the longest way from a coordinate to the sum's last step gives: with u = 2^-53, k
/// of them change a term by (1 + u)^k - 1 at most, and the last step never changes the sign. So a
/// value of (k u + O(u^2)) times the magnitude, or more, has the right sign; and where all terms
/// are zero, as among points along an axis, the value is zero for certain. Holds without underflow:
/// see the exact range of predicates.h.
struct Estimate {
  double value;
  double magnitude;

  /// Whether the value's sign is right after that many roundings of a term.
  template <int Roundings>
  bool is_certain_after() const {
    static_assert(Roundings <= 16);
    constexpr double u = 0x1p-53;
    // The 32 stands for all that is of the order of u^2, and for the roundings of the magnitude.
    constexpr double bound = Roundings * u * (1 + 32 * u);
    return std::abs(value) >= bound * magnitude;
  }
  /// Whether the value is exact: whether all coordinates are whole numbers of a unit so large that
  /// the terms, products of Degree differences, add up to less than 2^53 in it. Then nothing that
  /// counts has been rounded. So it is on lattices of moderate size, where values are often zero.
  template <int Degree, class... Coordinates>
  bool is_exact_for(Coordinates... coordinates) const {
    // magnitude < 2^(exponent + 1); the unit's exponent is (exponent - 52) / Degree, rounded up.
    const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(magnitude) >> 52);
    const int unit = (biased - 1075 + Degree * 1024 - 1) / Degree + 1 - 1024;
    // Adding 2^52 units leaves multiples of the unit alone, as the sum's last digit is worth one or
    // more.
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

/// The same with a larger bound for less work: a square adds up to that of the largest differences
/// along the axes at most, the six terms of a volume to six times their product, and there are four
/// of each.
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

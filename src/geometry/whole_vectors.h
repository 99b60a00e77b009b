#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "geometry/determinants.h"
#include "geometry/point.h"
#include "geometry/wide_integer.h"

/// This namespace holds what the exact stages of the predicates work with: differences of points as
/// whole numbers of one unit.
namespace thiessen::exact {

template <class P, class Number>
struct VectorBetween;
template <class Number>
struct VectorBetween<Point, Number> {
  using Type = PlaneVector<Number>;
};
template <class Number>
struct VectorBetween<SpacePoint, Number> {
  using Type = SpaceVector<Number>;
};

/// The vectors from the last of some points to the others, in units of 2^exponent.
template <class P, std::size_t Points, std::size_t Limbs>
struct WholeVectors {
  std::array<typename VectorBetween<P, WideInteger<Limbs>>::Type, Points - 1> to;
  int exponent;
};

template <class P>
inline constexpr std::size_t dimension_of = sizeof(P) / sizeof(double);

/// The coordinates of some points as whole numbers, digits * 2^exponent, in the largest unit in
/// which all are whole; and how many binary digits the differences from the last point take in it.
template <class P, std::size_t Points>
class WholeCoordinates {
 public:
  static constexpr std::size_t count = Points * dimension_of<P>;

  explicit WholeCoordinates(const std::array<P, Points>& points) {
    const std::array<double, count> coordinates = row_of(points);
    std::uint64_t largest = 0;
    for (std::size_t i = 0; i < count; ++i) {
      read(coordinates[i], i);
      const double difference =
          coordinates[i] - coordinates[count - dimension_of<P> + i % dimension_of<P>];
      largest = std::max(largest, std::bit_cast<std::uint64_t>(difference) << 1);
    }
    digits_of_differences_ = static_cast<int>(largest >> 53) - 1022 - unit_;
  }

  /// Whether the differences are below 2^(64 Limbs - 2) in magnitude, which leaves room for the
  /// sums in the determinants.
  template <std::size_t Limbs>
  bool fit() const {
    return digits_of_differences_ <= static_cast<int>(Limbs) * 64 - 2;
  }

  /// The vectors from the last point to the others. Requires that they fit into so many limbs.
  template <std::size_t Limbs>
  WholeVectors<P, Points, Limbs> differences() const {
    WholeVectors<P, Points, Limbs> vectors;
    for (std::size_t i = 0; i + 1 < Points; ++i) {
      vectors.to[i].x = from_last<Limbs>(i, 0);
      vectors.to[i].y = from_last<Limbs>(i, 1);
      if constexpr (dimension_of<P> == 3) vectors.to[i].z = from_last<Limbs>(i, 2);
    }
    vectors.exponent = unit_;
    return vectors;
  }

 private:
  static std::array<double, count> row_of(const std::array<P, Points>& points) {
    std::array<double, count> row;
    for (std::size_t i = 0; i < Points; ++i) {
      row[i * dimension_of<P>] = points[i].x;
      row[i * dimension_of<P> + 1] = points[i].y;
      if constexpr (dimension_of<P> == 3) row[i * dimension_of<P> + 2] = points[i].z;
    }
    return row;
  }
  void read(double coordinate, std::size_t i) {
    constexpr std::uint64_t leading_digit = std::uint64_t{1} << 52;
    const auto bits = std::bit_cast<std::uint64_t>(coordinate);
    const auto magnitude = (bits & (leading_digit - 1)) | leading_digit;
    const auto zeros = std::countr_zero(magnitude);
    const auto odd = static_cast<std::int64_t>(magnitude >> zeros);
    const auto sign = static_cast<std::int64_t>(bits) >> 63;
    const bool is_zero = bits << 1 == 0;
    digits_[i] = is_zero ? 0 : (odd ^ sign) - sign;
    exponents_[i] = is_zero ? 1024 : static_cast<int>(bits >> 52 & 0x7FF) - 1075 + zeros;
    unit_ = std::min(unit_, exponents_[i]);
  }

  template <std::size_t Limbs>
  WideInteger<Limbs> whole(std::size_t i) const {
    return WideInteger<Limbs>::shifted(digits_[i], exponents_[i] - unit_);
  }
  template <std::size_t Limbs>
  WideInteger<Limbs> from_last(std::size_t point, std::size_t axis) const {
    return whole<Limbs>(point * dimension_of<P> + axis) -
           whole<Limbs>((Points - 1) * dimension_of<P> + axis);
  }

  std::array<std::int64_t, count> digits_;
  std::array<int, count> exponents_;
  int unit_ = 1024;
  int digits_of_differences_;
};

/// Returns f(vectors), with the vectors from the last point to the others in the narrowest of three
/// widths that holds them. One limb holds nearly all that is measured: decimals at one offset,
/// degrees, lattices. Seven limbs hold all of the exact range: differences up to 2^202 in units of
/// 2^-194 or more.
template <class P, std::size_t Points, class F>
auto in_whole_numbers(const std::array<P, Points>& points, F f) {
  const WholeCoordinates<P, Points> whole(points);
  if (whole.template fit<1>()) [[likely]]
    return f(whole.template differences<1>());
  if (whole.template fit<2>()) return f(whole.template differences<2>());
  return f(whole.template differences<7>());
}

}  // namespace thiessen::exact

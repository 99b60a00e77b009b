#pragma once

#include <cmath>

namespace thiessen {

/// A number in two doubles, the second of which is what the first one rounds off (T. J. Dekker, A
/// floating-point technique for extending the available precision, 1971). Requires that no product
/// overflows, and that the rounding errors of products do not underflow.
struct DoubleSum {
  double high;
  double low;

  /// The sum of two doubles, exactly.
  static DoubleSum of_sum(double a, double b) {
    const double sum = a + b;
    const double part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
  }
  /// The difference of two doubles, exactly.
  static DoubleSum of_difference(double a, double b) { return of_sum(a, -b); }
};

/// A double in two halves of 26 digits, whose products are exact.
class HalvedDouble {
 public:
  explicit HalvedDouble(double value) : value_(value) {
    constexpr double splitter = 0x1p27 + 1;
    const double large = splitter * value;
    high_ = large - (large - value);
    low_ = value - high_;
  }
  double value() const { return value_; }
  /// The product, exactly.
  friend DoubleSum operator*(const HalvedDouble& a, const HalvedDouble& b) {
    const double product = a.value_ * b.value_;
    const double error =
        ((a.high_ * b.high_ - product) + a.high_ * b.low_ + a.low_ * b.high_) + a.low_ * b.low_;
    return {product, error};
  }

 private:
  double value_;
  double high_;
  double low_;
};

/// The sum a + sign * b. Its error is at most 2^-103 of the magnitudes of a and b together.
inline DoubleSum sum_of(const DoubleSum& a, double sign, const DoubleSum& b) {
  const DoubleSum high = DoubleSum::of_sum(a.high, sign * b.high);
  return DoubleSum::of_sum(high.high, high.low + (a.low + sign * b.low));
}

/// The product of a number in two doubles and a double. Its error is at most 2^-103 of it.
inline DoubleSum product_of(const DoubleSum& a, const HalvedDouble& b) {
  const DoubleSum high = HalvedDouble(a.high) * b;
  return DoubleSum::of_sum(high.high, high.low + a.low * b.value());
}

/// Whether `high` is the double nearest to all numbers that are no farther than `error` from the
/// sum, so that it is what the true one is rounded to.
inline bool rounds_for_certain(const DoubleSum& sum, double error) {
  return sum.high + (sum.low + error) == sum.high && sum.high + (sum.low - error) == sum.high;
}

}  // namespace thiessen

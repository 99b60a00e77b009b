#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// A round value, exact in decimal: digits x 10^exponent.
struct RoundValue {
  long long digits = 0;
  int exponent = 0;

  double value() const;
  /// The value as text: without an exponent where that takes few digits ("0.05", "-120"), else with
  /// one ("5e-9").
  std::string text() const;
};

/// Writes `digits` x 10^`exponent` as a decimal number, without trailing zeros after the point.
std::string decimal_text(long long digits, int exponent);

/// The values as texts with equally many digits after the point, unless one has an exponent.
std::vector<std::string> texts_of(const std::vector<RoundValue>& values);

/// The value rounded to at most nine significant digits.
RoundValue nine_digits(double value);

/// The value as a reader wants it: to two decimals, or to three significant digits where these are
/// more.
RoundValue few_digits(double value);

/// The largest value of so many significant digits that is not above `value`, and the smallest that
/// is not below it. Both require a finite value.
RoundValue round_down(double value, int digits);
RoundValue round_up(double value, int digits);

/// The roundest value from `low` to `high`: a multiple of the largest of 1, 2 and 5 x 10^n that has
/// one there, and of several the nearest to `wanted`. Where low and high are the same to nine
/// digits, it is that value. Requires finite values, low <= wanted <= high.
RoundValue roundest(double low, double wanted, double high);

/// The largest of 1, 2 and 5 x 10^n that is not above `limit`, which must be positive and finite.
RoundValue round_below(double limit);

/// Round values, equally spaced by 1, 2 or 5 x 10^n, the first at or below `least` and the last at
/// or above `largest`. The spacing is the finest that needs at most `classes` intervals. There is a
/// single value where both ends are the same to nine digits. Requires finite values, least <=
/// largest, classes >= 2.
std::vector<RoundValue> round_scale(double least, double largest, int classes);

}  // namespace thiessen

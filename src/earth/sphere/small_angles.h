#pragma once

namespace thiessen {

/// Series for angles of up to `small_angle` radians, some 300 km, and for their tangents and sines.
/// What is left out is below 2e-17 of the result, a tenth of its rounding: the first term left out
/// is 0.05^12 / 13 of an arc tangent, 0.0174 * 0.05^12 of an arc sine, 0.05^10 / 11! of a sine and
/// 0.05^10 / 10! of a cosine.
inline constexpr double small_angle = 0.05;

inline double small_arc_tangent(double t) {
  const double s = t * t;
  return t - t * s * (1. / 3 - s * (1. / 5 - s * (1. / 7 - s * (1. / 9 - s * (1. / 11)))));
}
inline double small_arc_sine(double x) {
  const double s = x * x;
  return x +
         x * s *
             (1. / 6 + s * (3. / 40 + s * (15. / 336 + s * (105. / 3456 + s * (945. / 42240)))));
}
inline double small_sine(double x) {
  const double s = x * x;
  return x - x * s * (1. / 6 - s * (1. / 120 - s * (1. / 5040 - s * (1. / 362880))));
}
inline double small_cosine(double x) {
  const double s = x * x;
  return 1 - s * (1. / 2 - s * (1. / 24 - s * (1. / 720 - s * (1. / 40320))));
}

}  // namespace thiessen

#include "earth/sphere/small_angles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

TEST(SmallAngles, are_the_library_s_to_the_last_bits) {
  constexpr double ulps = 4e-16;
  for (double x = small_angle; x > 1e-12; x *= 0.93) {
    for (const double angle : {x, -x}) {
      EXPECT_NEAR(small_arc_tangent(angle), std::atan(angle), ulps * x);
      EXPECT_NEAR(small_arc_sine(angle), std::asin(angle), ulps * x);
      EXPECT_NEAR(small_sine(angle), std::sin(angle), ulps * x);
      EXPECT_NEAR(small_cosine(angle), std::cos(angle), ulps);
    }
  }
  EXPECT_EQ(small_arc_tangent(0), 0);
  EXPECT_EQ(small_cosine(0), 1);
}

}  // namespace
}  // namespace thiessen

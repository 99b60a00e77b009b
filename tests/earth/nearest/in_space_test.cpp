#include "earth/nearest/in_space.h"

#include <gtest/gtest.h>

#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

TEST(InSpace, places_are_as_far_apart_as_a_straight_line_through_the_earth) {
  const Point denver{-105, 39.7};
  const Point grand_junction{-108.5, 39.1};
  const double chord =
      length(in_space(denver, Metric::geodesic) - in_space(grand_junction, Metric::geodesic));
  const double geodesic = geodesic_distance(denver, grand_junction);
  EXPECT_LT(chord, geodesic);
  // Of an arc of length d on a sphere of radius R the chord lacks d^2 / 24 R^2.
  EXPECT_NEAR(1 - chord / geodesic, geodesic * geodesic / (24 * 6.371e6 * 6.371e6), 1e-6);
}

}  // namespace
}  // namespace thiessen

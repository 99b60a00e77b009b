#include "earth/cells/border_length.h"

#include <gtest/gtest.h>

#include <numbers>

#include "earth/sphere/geodesic.h"

namespace thiessen {
namespace {

GeodesicBisector bisector_of(Point first, Point second) {
  const EarthPoint a(first);
  const EarthPoint b(second);
  return {a, b, BisectorArc(a.direction, b.direction), 1e-6};
}

BisectorEnd end_at(const GeodesicBisector& bisector, double angle) {
  return {angle, bisector.find(angle).position};
}

// Places on the equator: their border is the meridian between them, which is a geodesic.
TEST(BorderLength, along_a_meridian_is_the_geodesic) {
  const GeodesicBisector bisector = bisector_of({10, 0}, {12, 0});
  const BisectorEnd from = end_at(bisector, -0.7);
  const BisectorEnd to = end_at(bisector, 0.4);
  EXPECT_NEAR(border_length(bisector, from, to), geodesic_distance(from.position, to.position),
              1e-3);
}

// A border that is no geodesic is longer than the one between its ends.
TEST(BorderLength, is_the_sum_of_many_short_geodesics) {
  const GeodesicBisector bisector = bisector_of({10, 40}, {16, 46});
  constexpr int pieces = 20000;
  double sum = 0;
  for (int i = 0; i < pieces; ++i)
    sum += geodesic_distance(bisector.find(-0.5 + 1.0 * i / pieces).position,
                             bisector.find(-0.5 + 1.0 * (i + 1) / pieces).position);
  const BisectorEnd from = end_at(bisector, -0.5);
  const BisectorEnd to = end_at(bisector, 0.5);
  const double length = border_length(bisector, from, to);
  EXPECT_NEAR(length, sum, 1e-8 * sum);
  EXPECT_GE(length, geodesic_distance(from.position, to.position));
}

TEST(BorderLength, of_a_point_is_none) {
  const GeodesicBisector bisector = bisector_of({10, 40}, {16, 46});
  EXPECT_EQ(border_length(bisector, end_at(bisector, 0.1), end_at(bisector, 0.1)), 0);
}

}  // namespace
}  // namespace thiessen

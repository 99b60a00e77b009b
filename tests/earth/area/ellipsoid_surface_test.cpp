#include "earth/area/ellipsoid_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

// The Earth's whole area is 510,065,621,724,088.44 m2, as the documentation of GeographicLib has
// it.
TEST(EllipsoidSurface, of_all_longitudes_from_pole_to_pole_is_the_earth) {
  const EllipsoidSurface earth;
  EXPECT_NEAR(earth.under({-180, 90}, {180, 90}, -90), 510'065'621.724e6, 1e3);
}

TEST(EllipsoidSurface, is_positive_under_a_way_to_the_east_above_the_reference) {
  const EllipsoidSurface earth;
  EXPECT_GT(earth.under({10, 50}, {20, 50}, 40), 0);
  EXPECT_LT(earth.under({20, 50}, {10, 50}, 40), 0);
  EXPECT_LT(earth.under({10, 50}, {20, 50}, 60), 0);
  EXPECT_EQ(earth.under({10, 50}, {20, 50}, 50), 0);
  EXPECT_EQ(earth.under({10, 20}, {10, 50}, 0), 0) << "a meridian has nothing under it";
}

TEST(EllipsoidSurface, is_larger_at_the_equator_than_where_meridians_meet) {
  const EllipsoidSurface earth;
  const double equator = earth.under({0, 1}, {1, 1}, 0);
  const double pole = earth.under({0, 90}, {1, 90}, 89);
  EXPECT_NEAR(equator / 1e6, 110.57 * 111.31, 10) << "a degree of either kind in km";
  EXPECT_NEAR(pole / 1e6, 111.69 * 111.69 * M_PI / 360, 1) << "a 360th of a disc";
}

}  // namespace
}  // namespace thiessen

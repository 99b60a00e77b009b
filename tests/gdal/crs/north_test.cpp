#include "gdal/crs/north.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

Box around(Point middle, double half) {
  return Box{middle, middle}.grown(half);
}

TEST(North, is_up_in_longitude_and_latitude) {
  EXPECT_TRUE(north_is_up(Crs::wgs84(), around({10, 50}, 20)));
}

TEST(North, is_up_on_a_zones_meridian_and_a_few_degrees_beside_it) {
  const Crs utm = Crs::from_text("EPSG:32633", setting("plane"));
  EXPECT_TRUE(north_is_up(utm, around({500000, 5500000}, 100000)));
  EXPECT_TRUE(north_is_up(utm, around({700000, 5500000}, 100000)));
}

// The polar stereographic projection has north up on one meridian alone: elsewhere it turns.
TEST(North, is_not_up_where_a_polar_projection_has_turned_by_more_than_five_degrees) {
  const Crs polar = Crs::from_text("EPSG:3995", setting("plane"));
  EXPECT_TRUE(north_is_up(polar, around({0, -2000000}, 100000)));
  EXPECT_FALSE(north_is_up(polar, around({2000000, 0}, 100000)));
  EXPECT_FALSE(north_is_up(polar, around({0, 2000000}, 100000)));
}

// At the corners of the second map north is at 1000 km to the side and 500 km up: 63 degrees.
TEST(North, is_not_up_on_a_map_with_the_pole_or_nearly_so) {
  const Crs polar = Crs::from_text("EPSG:3995", setting("plane"));
  for (const Point pole : {Point{0, 0}, {0, -1}, {0, -100000}, {0, -900000}})
    EXPECT_FALSE(north_is_up(polar, around(pole, 1000000))) << pole.y;
  EXPECT_FALSE(north_is_up(polar, around({0, -1500000}, 1000000)));
  EXPECT_TRUE(north_is_up(polar, around({0, -2500000}, 1000000)));
}

}  // namespace
}  // namespace thiessen

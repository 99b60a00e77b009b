#include "gdal/crs/north.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(North, is_up_in_longitude_and_latitude) {
  EXPECT_TRUE(north_is_up(Crs::wgs84(), {10, 50}));
}

TEST(North, is_up_on_a_zones_meridian_and_a_few_degrees_beside_it) {
  const Crs utm = Crs::from_text("EPSG:32633", setting("plane"));
  EXPECT_TRUE(north_is_up(utm, {500000, 5500000}));
  EXPECT_TRUE(north_is_up(utm, {700000, 5500000}));
}

// The polar stereographic projection has north up on one meridian alone: elsewhere it turns.
TEST(North, is_not_up_where_a_polar_projection_has_turned_by_more_than_five_degrees) {
  const Crs polar = Crs::from_text("EPSG:3995", setting("plane"));
  EXPECT_TRUE(north_is_up(polar, {0, -2000000}));
  EXPECT_FALSE(north_is_up(polar, {2000000, 0}));
  EXPECT_FALSE(north_is_up(polar, {0, 2000000}));
}

}  // namespace
}  // namespace thiessen

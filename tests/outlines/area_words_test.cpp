#include "outlines/area_words.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

const MultiPolygon square = {{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}, {}}};

TEST(AreaWords, has_seven_digits_and_no_exponent) {
  EXPECT_EQ(rounded_text(0), "0");
  EXPECT_EQ(rounded_text(50), "50");
  EXPECT_EQ(rounded_text(0.1), "0.1");
  EXPECT_EQ(rounded_text(441233920.7), "441233921");
  EXPECT_EQ(rounded_text(1.23456789), "1.234568");
  EXPECT_EQ(rounded_text(0.00000312500), "0.000003125");
}

TEST(AreaWords, are_km2_where_the_unit_is_a_length) {
  EXPECT_EQ(area_words(square, CoordinateKind{false, 1}, false), "1 km2");
  EXPECT_EQ(area_words(square, CoordinateKind{false, 0.3048}, false), "0.09290304 km2");
}

TEST(AreaWords, are_bare_where_the_unit_is_unknown_or_degrees) {
  EXPECT_EQ(area_words(square, std::nullopt, false), "1000000");
  EXPECT_EQ(area_words(square, CoordinateKind{true, 1}, false), "1000000");
}

// GeographicLib's documentation of Planimeter: the ellipsoid has 510065621.724 km2.
TEST(AreaWords, are_the_ellipsoids_on_the_earth) {
  const MultiPolygon earth = {{{{-180, -90}, {180, -90}, {180, 90}, {-180, 90}}, {}}};
  EXPECT_EQ(area_words(earth, CoordinateKind{true, 1}, true), "510065622 km2");
}

}  // namespace
}  // namespace thiessen

#include "files/shape_target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "base/complaints.h"

namespace thiessen {
namespace {

const MultiPolygon over = {{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}};

TEST(ShapeTarget, leaves_shapes_where_there_is_no_crs) {
  ShapeTarget target({}, {}, 0.1);
  EXPECT_EQ(target.of(over, "it", "they").at(0).outer, over[0].outer);
}

TEST(ShapeTarget, cuts_degrees_at_the_antimeridian) {
  ShapeTarget target(Crs::wgs84(), Crs::wgs84(), 0.1);
  EXPECT_EQ(target.of(over, "it", "they").size(), 2U);
}

TEST(ShapeTarget, names_what_reaches_outside_the_area) {
  ShapeTarget target(Crs::wgs84(), Crs::from_text("EPSG:32633", setting("crs")), 0.1);
  const auto said = complaints_of([&] { target.of(over, "the triangle of a", "triangles"); });
  EXPECT_TRUE(contains(said.at(0), "the triangle of a reaches outside the area of EPSG:32633"))
      << said.at(0);
  EXPECT_TRUE(contains(said.at(0), "triangles in longitude and latitude (.geojson) reach anywhere"))
      << said.at(0);
}

}  // namespace
}  // namespace thiessen

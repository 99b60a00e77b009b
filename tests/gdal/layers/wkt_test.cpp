#include "gdal/layers/wkt.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(Wkt, points_and_polygons_have_their_coordinates_as_written) {
  const auto point = record_of_wkt("POINT (1.5 -2)");
  ASSERT_TRUE(point);
  EXPECT_EQ(point->type, "Point");
  EXPECT_EQ(point->points, (std::vector<Point>{{1.5, -2}}));
  const auto polygon = record_of_wkt("POLYGON ((0 0,4 0,4 4,0 0),(3 1,3 2,2 1,3 1))");
  ASSERT_TRUE(polygon);
  ASSERT_EQ(polygon->polygons.size(), 1U);
  EXPECT_EQ(polygon->polygons[0].outer, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 0}}));
  EXPECT_EQ(polygon->polygons[0].holes.at(0), (Ring{{3, 1}, {3, 2}, {2, 1}, {3, 1}}));
}

TEST(Wkt, case_and_blanks_do_not_count) {
  for (const char* text : {"point(1 2)", "  Point ( 1  2 )\r\n", "POINT (1 2)\t "}) {
    const auto record = record_of_wkt(text);
    ASSERT_TRUE(record) << text;
    EXPECT_EQ(record->points, (std::vector<Point>{{1, 2}})) << text;
  }
}

TEST(Wkt, nothing_is_no_geometry_and_an_empty_one_has_a_type) {
  for (const char* text : {"", " \t\r\n"}) EXPECT_EQ(record_of_wkt(text).value().type, "");
  const auto empty = record_of_wkt("POLYGON EMPTY");
  ASSERT_TRUE(empty);
  EXPECT_EQ(empty->type, "Polygon");
  EXPECT_TRUE(empty->polygons.empty());
}

TEST(Wkt, a_height_is_told_and_left_out) {
  const auto high = record_of_wkt("POINT Z (1 2 77)");
  ASSERT_TRUE(high);
  EXPECT_TRUE(high->has_z);
  EXPECT_EQ(high->points, (std::vector<Point>{{1, 2}}));
  EXPECT_FALSE(record_of_wkt("POINT (1 2)")->has_z);
}

TEST(Wkt, what_is_cut_off_or_followed_by_more_is_none) {
  for (const char* text : {"POINT", "POINT (1 2", "POINT (1)", "POINT (1 2) x", "POINT (1 2)(3 4)",
                           "CIRCLE (1 2)", "1 2", "POLYGON ((0 0,1 0,1 1,0 0)"})
    EXPECT_FALSE(record_of_wkt(text)) << text;
}

}  // namespace
}  // namespace thiessen

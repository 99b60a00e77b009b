#include "gdal/layers/wkt.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

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

/// Polygons in their plain form are read without GDAL; by a blank, GDAL reads the same.
TEST(Wkt, polygons_are_the_same_with_a_blank_more) {
  for (const std::string text :
       {"POLYGON((0.1 -2e3,4 0,4.25 4,0.1 -2e3))",
        "POLYGON ((0 0, 4 0, 4 4, 0 0), (3 1,3 2,2 1,3 1))",
        "MULTIPOLYGON (((0 0,4 0,4 4,0 0)),((7 7,9 7,8 9,7 7),(8 8,8 8.1,8.1 8,8 8)))",
        "POLYGON ((0.12345678901234567890 1,4 0,4 4,0.12345678901234567890 1))"}) {
    const auto plain = record_of_wkt(text);
    const auto by_gdal = record_of_wkt(' ' + text);
    ASSERT_TRUE(plain && by_gdal) << text;
    EXPECT_EQ(plain->type, by_gdal->type);
    EXPECT_FALSE(plain->has_z || by_gdal->has_z);
    EXPECT_FALSE(plain->polygons.empty());
    ASSERT_EQ(plain->polygons.size(), by_gdal->polygons.size());
    for (std::size_t i = 0; i < plain->polygons.size(); ++i) {
      EXPECT_EQ(plain->polygons[i].outer, by_gdal->polygons[i].outer);
      EXPECT_EQ(plain->polygons[i].holes, by_gdal->polygons[i].holes);
    }
  }
}

TEST(Wkt, polygons_of_another_form_are_what_gdal_takes_them_for) {
  EXPECT_TRUE(record_of_wkt("POLYGON Z ((0 0 1,4 0 1,4 4 1,0 0 1))").value().has_z);
  EXPECT_EQ(record_of_wkt("POLYGON ((0 0,4 0,4 4))").value().polygons.at(0).outer.size(), 3U);
  for (const char* text : {"POLYGON ((0 0,4 0,4 4,0 0)", "POLYGON ((0 0,4 0,4 4,0 0)) x",
                           "POLYGON ((a 0,4 0,4 4,a 0))", "POLYGON ((+1 0,4 0,4 4,+1 0))"})
    EXPECT_FALSE(record_of_wkt(text)) << text;
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

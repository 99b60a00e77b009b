#include "gdal/layers/geometry_text.h"

#include <gtest/gtest.h>

#include <vector>

namespace thiessen {
namespace {

void expect_point(const char* text, Point at, int srid) {
  const auto read = geometry_of_text(text);
  ASSERT_TRUE(read) << text;
  EXPECT_EQ(read->geometry.points, (std::vector<Point>{at})) << text;
  EXPECT_EQ(read->srid, srid) << text;
}

TEST(GeometryText, may_be_wkt_with_an_srid_or_without) {
  expect_point("POINT (1 2)", {1, 2}, 0);
  expect_point("SRID=4326;POINT(1 2)", {1, 2}, 4326);
  expect_point(" srid=25832; Point (1 2) ", {1, 2}, 25832);
}

// What PostGIS 3 prints for ST_MakePoint(1, 2), with ST_SetSRID(..., 4326), and big-endian by
// ST_AsEWKB(..., 'XDR').
TEST(GeometryText, may_be_what_postgis_prints) {
  expect_point("0101000000000000000000F03F0000000000000040", {1, 2}, 0);
  expect_point("0101000020E6100000000000000000F03F0000000000000040", {1, 2}, 4326);
  expect_point("0020000001000010E63FF00000000000004000000000000000", {1, 2}, 4326);
  expect_point("0101000020e6100000000000000000f03f0000000000000040", {1, 2}, 4326);
}

TEST(GeometryText, of_a_height_tells_it) {
  const auto read =
      geometry_of_text("01010000A0E6100000000000000000F03F00000000000000400000000000000840");
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->geometry.has_z);
  EXPECT_EQ(read->geometry.points, (std::vector<Point>{{1, 2}}));
  EXPECT_EQ(read->srid, 4326);
}

TEST(GeometryText, is_nothing_where_it_is_cut_or_anything_else) {
  for (const char* text :
       {"SRID=;POINT (1 2)", "SRID=x;POINT (1 2)", "SRID=4326;", "SRID=4326",
        "SRID=99999999;POINT (1 2)", "01", "0101000020E61000",
        "0101000020E6100000000000000000F03F00000000000000", "09FF", "01zz", "0", "POINT (1"}) {
    const auto read = geometry_of_text(text);
    EXPECT_TRUE(!read || read->geometry.points.empty()) << text;
  }
}

}  // namespace
}  // namespace thiessen

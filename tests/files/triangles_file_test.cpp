#include "files/triangles_file.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

TrianglesOutput one_triangle() {
  TrianglesOutput output;
  output.triangles.push_back({{"A", "B", "C"}, {{{{0, 0}, {4, 0}, {0, 3}}, {}}}});
  return output;
}

TEST(TrianglesFile, of_a_plane_without_a_crs_keeps_all_digits) {
  Warnings warnings;
  TrianglesOutput output = one_triangle();
  output.triangles[0].shape[0].outer[1].x = 1.0 / 3;
  EXPECT_TRUE(contains(triangles_geojson(output, "t", warnings), "[0.3333333333333333,0]"));
  EXPECT_TRUE(warnings.messages().empty());
}

TEST(TrianglesFile, in_degrees_has_seven_decimals_and_more_where_a_triangle_is_thin) {
  Warnings warnings;
  TrianglesOutput output = one_triangle();
  output.study_crs = Crs::wgs84();
  output.triangles[0].shape[0].outer[1].x = 1.0 / 3;
  EXPECT_TRUE(contains(triangles_geojson(output, "t", warnings), "[0.3333333,0]"));
  output.triangles[0].shape = {{{{0, 0}, {4, 0}, {2, 1e-9}}, {}}};
  EXPECT_FALSE(contains(triangles_geojson(output, "t", warnings), "null"));
  EXPECT_TRUE(warnings.messages().empty());
}

TEST(TrianglesFile, tells_of_one_that_has_no_geometry) {
  Warnings warnings;
  TrianglesOutput output = one_triangle();
  output.triangles[0].shape = {{{{0, 0}, {4, 0}, {2, 0}}, {}}};
  EXPECT_TRUE(contains(triangles_geojson(output, "t", warnings), "\"geometry\":null"));
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_EQ(sentences_of(warnings)[0],
            "t: the triangle of stations 'A', 'B' and 'C' has no geometry: it is narrower than the "
            "coordinates can tell");
}

TEST(TrianglesFile, goes_into_any_format_by_extension) {
  Warnings warnings;
  for (const char* name : {"t.geojson", "t.gpkg", "t.shp", "t.fgb"}) {
    TrianglesOutput output = one_triangle();
    output.study_crs = Crs::wgs84();
    const auto files = triangles_files(output, name, warnings);
    ASSERT_FALSE(files.empty());
    EXPECT_EQ(files[0].name, name);
    EXPECT_FALSE(files[0].bytes.empty()) << name;
  }
}

}  // namespace
}  // namespace thiessen

#include "gdal/output/layer_formats.h"

#include <gtest/gtest.h>

#include "base/complaints.h"

namespace thiessen {
namespace {

TEST(Extension, is_what_stands_behind_the_last_dot_of_the_name) {
  EXPECT_EQ(extension_of("a.GPKG"), "gpkg");
  EXPECT_EQ(extension_of("a.b.shp"), "shp");
  EXPECT_EQ(extension_of("a.b/c"), "");
  EXPECT_EQ(extension_of("c"), "");
  EXPECT_EQ(extension_of("c."), "");
  EXPECT_EQ(extension_of(".gpkg"), "gpkg");
}

TEST(VectorDriver, is_known_by_the_extension) {
  for (const char* path : {"c.gpkg", "c.shp", "c.fgb", "c.kml", "c.gml", "c.csv", "x/c.GeoJSONL"})
    EXPECT_NO_THROW(require_vector_driver(path)) << path;
  EXPECT_TRUE(complaint_of([] { require_vector_driver("c.xyz"); })
                  .starts_with("c.xyz: no vector format has the extension .xyz | cells are written "
                               "to .geojson, .json, .gpkg, .shp"));
  EXPECT_TRUE(contains(complaint_of([] { require_vector_driver("a.b/c"); }),
                       "the extension tells the format, and there is none"));
  for (const char* sheet : {"c.xlsx", "c.ods"})
    EXPECT_THROW(require_vector_driver(sheet), Error) << "spreadsheets hold no geometry";
}

TEST(LayerFormats, of_degrees_only_want_coordinates_whose_crs_is_known) {
  for (const char* path : {"l.kml", "l.kmz", "l.geojsonl"}) {
    EXPECT_THROW(require_known_degrees(path, false), Error) << path;
    EXPECT_NO_THROW(require_known_degrees(path, true)) << path;
  }
  EXPECT_NO_THROW(require_known_degrees("l.gpkg", false));
  EXPECT_TRUE(holds_degrees_only("kml"));
  EXPECT_FALSE(holds_degrees_only("gpkg"));
}

}  // namespace
}  // namespace thiessen

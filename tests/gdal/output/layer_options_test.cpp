#include "gdal/output/layer_options.h"

#include <cpl_string.h>
#include <gtest/gtest.h>

namespace thiessen {
namespace {

VectorLayer layer_with(const std::vector<FieldName>& fields) {
  VectorLayer layer;
  layer.fields = fields;
  layer.values.text = [](std::size_t, std::size_t) { return std::string(); };
  return layer;
}

std::string option(const VectorLayer& layer, const char* driver, const char* name) {
  const CPLStringList options = layer_options(layer, driver, true, "x");
  const char* value = options.FetchNameValue(name);
  return value == nullptr ? "" : value;
}

TEST(LayerOptions, give_a_formats_own_columns_names_that_no_field_has) {
  const VectorLayer plain = layer_with({{"station", FieldType::text}});
  EXPECT_EQ(option(plain, "GPKG", "FID"), "fid");
  const VectorLayer taken = layer_with({{"FID", FieldType::text}, {"geom", FieldType::text}});
  EXPECT_EQ(option(taken, "GPKG", "FID"), "fid_");
  EXPECT_EQ(option(taken, "GPKG", "GEOMETRY_NAME"), "geom_");
  EXPECT_EQ(option(plain, "SQLite", "LAUNDER"), "NO");
  EXPECT_THROW(option(layer_with({{"OGC_FID", FieldType::text}}), "SQLite", "FID"), Error);
}

TEST(LayerOptions, make_nothing_depend_on_the_day_and_say_the_encoding) {
  VectorLayer layer = layer_with({{"basin", FieldType::text}});
  EXPECT_EQ(option(layer, "ESRI Shapefile", "DBF_DATE_LAST_UPDATE"), "1970-01-01");
  EXPECT_EQ(option(layer, "ESRI Shapefile", "ENCODING"), "UTF-8");
  EXPECT_EQ(option(layer, "MapInfo File", "ENCODING"), "");
  layer.values.rows = 1;
  layer.values.text = [](std::size_t, std::size_t) { return std::string("ő"); };
  EXPECT_EQ(option(layer, "MapInfo File", "ENCODING"), "UTF-8");
}

TEST(LayerOptions, say_how_a_layer_was_made_where_the_format_has_a_place) {
  VectorLayer layer = layer_with({});
  EXPECT_EQ(option(layer, "PGDUMP", "DESCRIPTION"), "");
  layer.made_by = Provenance();
  layer.made_by->software = "thiessen 0";
  EXPECT_EQ(option(layer, "PGDUMP", "DESCRIPTION").rfind("thiessen 0", 0), 0U);
  EXPECT_NE(option(layer, "GeoJSON", "NATIVE_DATA").find("\"tolerance\":0.1"), std::string::npos)
      << "a number, as in the GeoJSON of cells";
  EXPECT_NE(option(layer, "GeoJSON", "NATIVE_DATA").find("\"software\":\"thiessen 0\""),
            std::string::npos);
  EXPECT_EQ(option(layer, "GeoJSON", "RFC7946"), "YES");
  const CPLStringList plane = layer_options(layer, "GeoJSON", false, "x");
  EXPECT_EQ(plane.FetchNameValue("RFC7946"), nullptr);
}

}  // namespace
}  // namespace thiessen

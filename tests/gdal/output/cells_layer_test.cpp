#include "gdal/output/cells_layer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "gdal/layers/layer.h"

namespace thiessen {
namespace {

const MultiPolygon square = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};

CellFeature cell(const std::string& station, double rainfall) {
  CellFeature feature;
  feature.station = station;
  feature.basin = "B";
  feature.area = 1.0 / 3;
  feature.weight = 0.25;
  feature.rainfall = rainfall;
  return feature;
}

CellFeatures two_cells() {
  CellFeatures features;
  features.cells = {cell("007", 12.5), cell("a,b", std::nan(""))};
  features.has_rainfall = true;
  return features;
}

std::string bytes(const CellFeatures& features, const std::string& path) {
  const std::vector<MultiPolygon> shapes(features.cells.size(), square);
  Warnings warnings;
  return write_cells_layer(features, shapes, std::nullopt, path, "", warnings).at(0).bytes;
}

TEST(CellsLayer, as_csv_is_text_with_a_column_of_wkt) {
  const std::string ring = "\"MULTIPOLYGON (((0 0,1 0,1 1,0 1,0 0)))\"";
  EXPECT_EQ(bytes(two_cells(), "c.csv"), "WKT,station,basin,area_km2,weight,rainfall\n" + ring +
                                             ",\"007\",B,0.333333333333333,0.25,12.5\n" + ring +
                                             ",\"a,b\",B,0.333333333333333,0.25,\n");
}

TEST(CellsLayer, has_no_column_of_basins_or_rainfall_where_there_are_none) {
  CellFeatures features = two_cells();
  features.has_rainfall = false;
  for (CellFeature& feature : features.cells) feature.basin.reset();
  EXPECT_TRUE(bytes(features, "c.csv").starts_with("WKT,station,area_km2,weight\n"));
}

TEST(CellsLayer, attributes_keep_their_types_and_an_empty_text_is_no_value) {
  Attributes attributes;
  attributes.fields = {
      {"Weight", FieldType::text}, {"n", FieldType::integer}, {"h", FieldType::real}};
  attributes.rows = {{"x", "12345678901234567", "1.5"}, {"", "", ""}};
  CellFeatures features = two_cells();
  features.attributes = &attributes;
  features.cells[1].attribute_row = 1;
  const TemporaryFolder folder;
  Layer layer(folder.write("c.gpkg", bytes(features, "c.gpkg")), "", "");
  EXPECT_EQ(layer.header(), (std::vector<std::string>{"station", "basin", "area_km2", "weight",
                                                      "rainfall", "Weight_", "n", "h"}));
  EXPECT_EQ(layer.types()[6], FieldType::integer);
  EXPECT_EQ(layer.types()[7], FieldType::real);
  Row row;
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(row.fields[2], "0.3333333333333333");
  EXPECT_EQ(row.fields[6], "12345678901234567");
  EXPECT_EQ(row.fields[7], "1.5");
  ASSERT_TRUE(layer.next(row));
  for (const std::size_t field : {4U, 5U, 6U, 7U}) EXPECT_EQ(row.fields[field], "") << field;
}

TEST(CellsLayer, law_1_cells_come_in_their_order) {
  CellFeatures features;
  for (int i = 0; i < 300; ++i) features.cells.push_back(cell(std::to_string(i * 7 % 300), 0));
  const TemporaryFolder folder;
  Layer layer(folder.write("c.gpkg", bytes(features, "c.gpkg")), "", "");
  Row row;
  for (const CellFeature& feature : features.cells) {
    ASSERT_TRUE(layer.next(row));
    ASSERT_EQ(row.fields[0], feature.station);
  }
}

// KML's colours are alpha, blue, green, red.
TEST(CellsLayer, as_kml_has_names_and_colours) {
  CellFeatures features = two_cells();
  features.colours = {{1, 2, 3}, {255, 128, 0}};
  const std::string kml = bytes(features, "c.kml");
  EXPECT_TRUE(contains(kml, "<name>" + features.cells[0].station + "</name>")) << kml;
  EXPECT_TRUE(contains(kml, "<color>b0030201</color>")) << kml;
  EXPECT_TRUE(contains(kml, "<color>b00080ff</color>")) << kml;
  EXPECT_FALSE(contains(bytes(features, "c.csv"), "Name"));
}

TEST(CellsLayer, refuses_what_the_format_would_cut_off) {
  CellFeatures features = two_cells();
  features.cells[0].station = std::string(300, 'x');
  EXPECT_TRUE(contains(complaint_of([&] { bytes(features, "c.shp"); }), "c.shp: "));
  EXPECT_NO_THROW(bytes(features, "c.fgb"));
}

}  // namespace
}  // namespace thiessen

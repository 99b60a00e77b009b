#include "results/cells_geojson.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "base/complaints.h"
#include "text/geojson_audit.h"
#include "text/text_bytes.h"

namespace thiessen {
namespace {

const MultiPolygon square = {{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}};

CellFeature cell(const std::string& station, const std::optional<std::string>& basin = {},
                 double area_km2 = 1, double rainfall = 0) {
  CellFeature feature;
  feature.station = station;
  feature.basin = basin;
  feature.area = area_km2;
  feature.weight = 0.25;
  feature.rainfall = rainfall;
  return feature;
}

CellFeatures features_of(std::vector<CellFeature> cells) {
  CellFeatures features;
  features.cells = std::move(cells);
  return features;
}

/// The text of the cells, which is whole GeoJSON of as many features.
std::string written(const CellFeatures& features, const std::vector<MultiPolygon>& shapes) {
  const std::string text = cells_geojson(features, shapes, {});
  TextBytes bytes(text);
  EXPECT_EQ(audit_geojson("cells.geojson", bytes).features, shapes.size());
  return text;
}

std::string properties(const CellFeatures& features) {
  const std::string text = written(features, {square});
  const std::size_t begin = text.find(R"("properties":)") + 13;
  return text.substr(begin, text.find(R"(,"geometry")") - begin);
}

std::string geometry(const MultiPolygon& shape) {
  const std::string text = written(features_of({cell("a")}), {shape});
  const std::size_t begin = text.find(R"("geometry":)") + 11;
  return text.substr(begin, text.find("\n]}") - begin - 1);
}

TEST(CellsGeoJsonText, has_one_feature_a_line) {
  EXPECT_EQ(written(features_of({}), {}), "{\"type\":\"FeatureCollection\",\"features\":[\n]}\n");
  const std::string two = written(features_of({cell("a"), cell("b")}), {square, square});
  EXPECT_TRUE(contains(two, "}},\n{\"type\":\"Feature\",\"properties\":{\"station\":\"b\""));
}

TEST(CellsGeoJsonText, has_a_basin_and_rainfall_only_where_there_are_any) {
  CellFeatures features = features_of({cell("a", std::nullopt, 0.1, 12.5)});
  EXPECT_EQ(properties(features), R"({"station":"a","area_km2":0.1,"weight":0.25})");
  features.cells[0].basin = "";
  features.has_rainfall = true;
  EXPECT_EQ(properties(features),
            R"({"station":"a","basin":"","area_km2":0.1,"weight":0.25,"rainfall":12.5})");
}

// JSON has no NaN and no infinity.
TEST(CellsGeoJsonText, a_number_that_cannot_be_had_is_null) {
  const double infinity = std::numeric_limits<double>::infinity();
  CellFeatures features = features_of({cell("a", std::nullopt, infinity, std::nan(""))});
  features.has_rainfall = true;
  EXPECT_EQ(properties(features),
            R"({"station":"a","area_km2":null,"weight":0.25,"rainfall":null})");
}

TEST(CellsGeoJsonText, attributes_are_written_by_their_types) {
  Attributes attributes;
  attributes.fields = {{"code", FieldType::text},
                       {"n", FieldType::integer},
                       {"h", FieldType::real},
                       {"Weight", FieldType::text}};
  attributes.rows = {
      {"-", "-", "-", "-"}, {"007", "12345678901234567", "1.50", "a\"b"}, {"", "", "", ""}};
  CellFeatures features = features_of({cell("a")});
  features.attributes = &attributes;
  const std::string own = R"({"station":"a","area_km2":1,"weight":0.25,)";
  features.cells[0].attribute_row = 1;
  EXPECT_EQ(properties(features),
            own + R"("code":"007","n":12345678901234567,"h":1.5,"Weight_":"a\"b"})");
  features.cells[0].attribute_row = 2;
  EXPECT_EQ(properties(features), own + R"("code":null,"n":null,"h":null,"Weight_":null})");
}

TEST(CellsGeoJsonText, a_shape_is_null_a_polygon_or_several_with_closed_rings) {
  EXPECT_EQ(geometry({}), "null");
  EXPECT_EQ(geometry(square),
            R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]})");
  const Ring hole = {{0.25, 0.25}, {0.25, 0.5}, {0.5, 0.25}};
  const std::string ring = "[[0,0],[1,0],[1,1],[0,1],[0,0]]";
  const std::string inner = "[[0.25,0.25],[0.25,0.5],[0.5,0.25],[0.25,0.25]]";
  EXPECT_EQ(
      geometry({{square[0].outer, {hole}}, square[0]}),
      R"({"type":"MultiPolygon","coordinates":[[)" + ring + "," + inner + "],[" + ring + "]]}");
}

TEST(CellsGeoJsonText, vertices_have_the_digits_of_the_rounding) {
  const std::vector<MultiPolygon> shapes = {{{{{0, 0}, {1.0 / 3, 0}, {0, 1}}, {}}}};
  EXPECT_TRUE(contains(cells_geojson(features_of({cell("a")}), shapes, VertexRounding(shapes, 4)),
                       "[[0,0],[0.3333,0],[0,1],[0,0]]"));
  EXPECT_TRUE(contains(cells_geojson(features_of({cell("a")}), shapes, VertexRounding()),
                       "[0.3333333333333333,0]"));
}

}  // namespace
}  // namespace thiessen

#include <fcntl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "base/complaints.h"
#include "base/number.h"
#include "base/temporary_folder.h"
#include "files/cells_file.h"
#include "gdal/layers/layer.h"
#include "outlines/ring_direction.h"
#include "text/geojson_audit.h"
#include "text/text_bytes.h"

namespace thiessen {
namespace {

CellFeature cell(const std::string& station, MultiPolygon shape) {
  CellFeature feature;
  feature.station = station;
  feature.basin = "B";
  feature.area = 0.1;
  feature.weight = 1.0 / 3.0;
  feature.shape = std::move(shape);
  return feature;
}

CellsOutput output(std::vector<CellFeature> cells) {
  CellsOutput wanted;
  wanted.cells = std::move(cells);
  wanted.study_crs = Crs::wgs84();
  return wanted;
}

std::string geojson_of(const CellsOutput& wanted) {
  Warnings warnings;
  return cells_geojson(wanted, "cells.geojson", warnings);
}

/// One cell as another reader has it.
struct ReadBack {
  std::vector<std::string> fields;
  MultiPolygon shape;
};

std::vector<ReadBack> read_back(const CellsOutput& wanted) {
  const TemporaryFolder folder;
  const std::string text = geojson_of(wanted);
  const std::string file = folder.write("cells.geojson", text);
  TextBytes bytes(text);
  audit_geojson(file, bytes);
  Layer layer(file, "", "");
  std::vector<ReadBack> cells;
  for (Row row; layer.next(row);) {
    cells.push_back({{row.fields.begin(), row.fields.end()}, layer.geometry().polygons});
  }
  return cells;
}

const Polygon square = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}};

TEST(CellsGeoJson, is_what_it_was_yesterday) {
  EXPECT_EQ(
      geojson_of(output({cell("A", {square})})),
      "{\"type\":\"FeatureCollection\",\"features\":[\n"
      "{\"type\":\"Feature\",\"properties\":{\"station\":\"A\",\"basin\":\"B\",\"area_km2\":0.1,"
      "\"weight\":0.3333333333333333},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":"
      "[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}}\n]}\n");
}

/// What is written of the cells of a source; nothing where that cannot be done one at a time.
std::optional<std::string> written_singly(const CellsOutput& wanted) {
  const TemporaryFolder folder;
  OutputFile file("cells.geojson", open_descriptor(folder.path("c"), O_WRONLY | O_CREAT, 0600),
                  OutputFile::Care::synced);
  CellsOutput common = wanted;
  common.cells.clear();
  const bool done = append_cells_geojson(
      file, common, [&](const std::function<bool(const CellFeature& cell)>& take) {
        for (const CellFeature& cell : wanted.cells) {
          if (!take(cell)) return;
        }
      });
  file.finish();
  if (!done) {
    EXPECT_EQ(folder.read("c"), "");
    return std::nullopt;
  }
  return folder.read("c");
}

TEST(CellsGeoJson, is_the_same_where_cells_come_one_at_a_time) {
  CellsOutput wanted = output({cell("A", {square}), cell("B", {{{{1, 0}, {2, 0}, {1, 1}}, {}}})});
  wanted.study_crs.reset();
  EXPECT_EQ(written_singly(wanted), geojson_of(wanted));
  wanted.cells.clear();
  EXPECT_EQ(written_singly(wanted), geojson_of(wanted));
}

TEST(CellsGeoJson, waits_for_all_cells_where_one_has_no_valid_shape) {
  std::vector<CellFeature> cells(10'000, cell("A", {square}));  // more than a buffer holds
  CellsOutput wanted = output(std::move(cells));
  wanted.study_crs.reset();
  wanted.cells.push_back(cell("crossed", {{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}}));
  EXPECT_EQ(written_singly(wanted), std::nullopt);
  wanted.cells.back() = cell("none", {});
  EXPECT_EQ(written_singly(wanted), std::nullopt);
}

TEST(CellsGeoJson, waits_for_all_cells_where_vertices_are_rounded) {
  EXPECT_EQ(written_singly(output({cell("A", {square})})), std::nullopt);
}

TEST(CellsGeoJson, has_seven_decimals_at_a_decimetre) {
  CellsOutput wanted = output({cell("A", {{{{0.123456789, 0}, {1, 0}, {1, 1.00000004}}, {}}})});
  EXPECT_TRUE(contains(geojson_of(wanted), "[[0.1234568,0],[1,0],[1,1],[0.1234568,0]]"));
  wanted.tolerance = 0.01;
  EXPECT_TRUE(contains(geojson_of(wanted), "[[0.12345679,0],[1,0],[1,1.00000004],[0.12345679,0]]"));
}

TEST(CellsGeoJson, numbers_read_back_to_the_same_double) {
  CellFeature odd = cell("A", {square});
  odd.area = std::nextafter(12345.678, 0);
  odd.weight = 4.9406564584124654e-10;
  odd.rainfall = std::nextafter(0.1, 1);
  CellsOutput wanted = output({odd});
  wanted.has_rainfall = true;
  const auto cells = read_back(wanted);
  EXPECT_EQ(parse_number(cells.at(0).fields.at(2)).value, odd.area);
  EXPECT_EQ(parse_number(cells.at(0).fields.at(3)).value, odd.weight);
  EXPECT_EQ(parse_number(cells.at(0).fields.at(4)).value, odd.rainfall);
}

TEST(CellsGeoJson, a_value_that_cannot_be_had_is_null) {
  CellFeature dry = cell("A", {square});
  dry.rainfall = std::numeric_limits<double>::quiet_NaN();
  CellsOutput wanted = output({dry});
  wanted.has_rainfall = true;
  EXPECT_TRUE(contains(geojson_of(wanted), "\"rainfall\":null"));
}

TEST(CellsGeoJson, texts_are_safe_and_come_back) {
  const std::string hostile = "a\"b\\c</script>\xE2\x80\xA8\n\x1b[2J\x7f\xF0\x9F\x98\x80";
  const CellsOutput wanted = output({cell(hostile, {square})});
  const std::string text = geojson_of(wanted);
  EXPECT_TRUE(contains(text, R"(a\"b\\c\u003c/script>\u2028\u000a\u001b[2J\u007f)"));
  EXPECT_EQ(read_back(wanted).at(0).fields.at(0), hostile);
}

TEST(CellsGeoJson, attributes_keep_their_types_and_give_way_to_the_cells_own_names) {
  Attributes attributes;
  attributes.fields = {
      {"Station", FieldType::text}, {"elev", FieldType::integer}, {"h", FieldType::real}};
  attributes.rows = {{"007", "12", "1.50"}, {"", "", ""}};
  CellFeature second = cell("C", {square});
  second.attribute_row = 1;
  CellsOutput wanted = output({cell("A", {square}), second});
  wanted.attributes = &attributes;
  const std::string text = geojson_of(wanted);
  EXPECT_TRUE(contains(text, R"("Station_":"007","elev":12,"h":1.5})")) << text;
  EXPECT_TRUE(contains(text, R"("Station_":null,"elev":null,"h":null})")) << text;
}

TEST(CellsGeoJson, gives_more_decimals_where_a_cell_would_collapse) {
  // A sliver 1e-9 degrees wide between two neighbours: its vertices, and only these, are finer.
  const double x = 0.5;
  const double y = 0.500000001;
  const CellsOutput wanted =
      output({cell("A", {{{{0, 0}, {x, 0}, {x, 1}, {0, 1}}, {}}}),
              cell("B", {{{{x, 0}, {y, 0}, {y, 1}, {x, 1}}, {}}}),
              cell("C", {{{{y, 0}, {1, 0}, {1.0 / 3 + 1, 1}, {y, 1}}, {}}})});
  const auto cells = read_back(wanted);
  EXPECT_EQ(cells.at(0).shape.at(0).outer, (Ring{{0, 0}, {x, 0}, {x, 1}, {0, 1}, {0, 0}}));
  EXPECT_EQ(cells.at(1).shape.at(0).outer, (Ring{{x, 0}, {y, 0}, {y, 1}, {x, 1}, {x, 0}}));
  EXPECT_EQ(cells.at(2).shape.at(0).outer, (Ring{{y, 0}, {1, 0}, {1.3333333, 1}, {y, 1}, {y, 0}}));
}

TEST(CellsGeoJson, writes_all_digits_where_it_must) {
  const double x = 0.5;
  const double y = std::nextafter(0.5, 1);
  const auto cells = read_back(output({cell("B", {{{{x, 0}, {y, 0}, {y, 1}, {x, 1}}, {}}})}));
  EXPECT_EQ(cells.at(0).shape.at(0).outer, (Ring{{x, 0}, {y, 0}, {y, 1}, {x, 1}, {x, 0}}));
}

TEST(CellsGeoJson, vertices_that_fall_together_stand_once) {
  const CellsOutput wanted = output(
      {cell("A", {{{{0, 0}, {1, 0}, {1, 1}, {1 + 1e-9, 1 + 1e-9}, {0, 1}, {1e-9, 1e-9}}, {}}})});
  EXPECT_TRUE(contains(geojson_of(wanted), "[[[0,0],[1,0],[1,1],[0,1],[0,0]]]"));
}

TEST(CellsGeoJson, a_plane_without_crs_writes_its_own_coordinates) {
  CellsOutput wanted =
      output({cell("A", {{{{500000.123456789, 1e7}, {500001, 1e7}, {500001, 10000001}}, {}}})});
  wanted.study_crs.reset();
  const std::string text = geojson_of(wanted);
  EXPECT_TRUE(contains(text, "[[[500000.123456789,10000000],[500001,10000000],"));
  EXPECT_FALSE(contains(text, "crs"));
}

TEST(CellsGeoJson, a_plane_with_crs_is_taken_to_wgs84_along_its_edges) {
  CellsOutput wanted =
      output({cell("A", {{{{600000, 5500000}, {700000, 5500000}, {700000, 5600000}}, {}}}),
              cell("B", {{{{600000, 5500000}, {700000, 5600000}, {600000, 5600000}}, {}}})});
  wanted.study_crs = Crs::from_text("EPSG:32633", setting("plane"));
  const auto cells = read_back(wanted);
  const Ring a = cells.at(0).shape.at(0).outer;
  Ring b = cells.at(1).shape.at(0).outer;
  EXPECT_GT(a.size(), 100U);
  EXPECT_GT(signed_area(a), 0);
  // The shared edge: the last of A, backwards, is the first of B, vertex for vertex.
  std::size_t shared = 0;
  while (shared < b.size() && b[shared] == a[a.size() - 1 - shared]) ++shared;
  EXPECT_GT(shared, 50U);
  EXPECT_EQ(a.size() - 1 - (shared - 1) > 0, true);
  EXPECT_LT(std::abs(b[shared - 1].x - a[a.size() - shared].x), 1e-12);
}

TEST(CellsGeoJson, is_cut_at_the_antimeridian) {
  const CellsOutput wanted = output({cell("A", {{{{170, 0}, {190, 0}, {190, 10}, {170, 10}}, {}}}),
                                     cell("B", {{{{170, 10}, {190, 10}, {185, 20}}, {}}})});
  const auto cells = read_back(wanted);
  ASSERT_EQ(cells.at(0).shape.size(), 2U);
  double area = 0;
  for (const Polygon& polygon : cells[0].shape) {
    area += signed_area(polygon.outer);
    for (const Point point : polygon.outer) EXPECT_LE(std::abs(point.x), 180);
  }
  EXPECT_DOUBLE_EQ(area, 200);
  EXPECT_EQ(cells.at(1).shape.size(), 2U);
}

TEST(CellsGeoJson, of_no_cells_is_an_empty_collection) {
  EXPECT_EQ(geojson_of(output({})), "{\"type\":\"FeatureCollection\",\"features\":[\n]}\n");
}

}  // namespace
}  // namespace thiessen

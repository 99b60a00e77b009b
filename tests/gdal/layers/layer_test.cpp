#include "gdal/layers/layer.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/complaints.h"
#include "base/temporary_folder.h"
#include "files/cells_file.h"

namespace thiessen {
namespace {

/// Runs a command of GDAL's own.
void run(const std::string& command) {
  ASSERT_EQ(std::system((command + " >/dev/null 2>&1").c_str()), 0) << command;
}

std::string quoted_path(const TemporaryFolder& folder, const std::string& name) {
  return "'" + folder.path(name) + "'";
}

/// Turns a CSV into another format.
std::string converted(const TemporaryFolder& folder, const std::string& csv,
                      const std::string& name, const std::string& options = "") {
  folder.write("in.csv", csv);
  run("ogr2ogr " + options + " " + quoted_path(folder, name) + " " + quoted_path(folder, "in.csv"));
  return folder.path(name);
}

std::vector<std::vector<std::string>> rows_of(Layer& layer) {
  std::vector<std::vector<std::string>> rows;
  for (Row row; layer.next(row);) rows.emplace_back(row.fields.begin(), row.fields.end());
  return rows;
}

TEST(Layer, several_layers_want_one_named) {
  const TemporaryFolder folder;
  const std::string file = converted(folder, "id,x\na,1\n", "two.gpkg", "-nln first");
  run("ogr2ogr -update -nln second " + quoted_path(folder, "two.gpkg") + " " +
      quoted_path(folder, "in.csv"));
  EXPECT_EQ(complaint_of([&] { Layer(file, "", "stations_layer"); }),
            file + ": has several layers: 'first', 'second' | name one with 'stations_layer'");
  EXPECT_EQ(complaint_of([&] { Layer(file, "third", "stations_layer"); }),
            file + ": has no layer 'third' | its layers are 'first', 'second'");
  Layer layer(file, "second", "");
  EXPECT_EQ(rows_of(layer), (std::vector<std::vector<std::string>>{{"a", "1"}}));
}

class Spreadsheet : public testing::TestWithParam<const char*> {};

TEST_P(Spreadsheet, gives_its_cells_as_text) {
  const TemporaryFolder folder;
  Layer layer(converted(folder, "id,lon,note\n007,-6.5,\n010,-7.25,b\n", GetParam()), "", "");
  EXPECT_EQ(layer.header(), (std::vector<std::string>{"id", "lon", "note"}));
  EXPECT_EQ(rows_of(layer),
            (std::vector<std::vector<std::string>>{{"007", "-6.5", ""}, {"010", "-7.25", "b"}}));
  EXPECT_FALSE(layer.crs());
}

INSTANTIATE_TEST_SUITE_P(Layer, Spreadsheet, testing::Values("a.xlsx", "a.ods"));

TEST(Layer, numbers_come_in_their_shortest_digits_and_rows_are_counted) {
  const TemporaryFolder folder;
  const std::string file =
      converted(folder, "id,n,r\na,12,0.1\nb,-3,2.50\n", "a.gpkg", "-oo AUTODETECT_TYPE=YES");
  Layer layer(file, "", "");
  EXPECT_EQ(layer.types(),
            (std::vector<FieldType>{FieldType::text, FieldType::integer, FieldType::real}));
  Row row;
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(row.line, 1U);
  EXPECT_EQ(row.fields[2], "0.1");
  ASSERT_TRUE(layer.next(row));
  EXPECT_EQ(row.line, 2U);
  EXPECT_EQ(row.fields[2], "2.5");
}

TEST(Layer, kml_and_shapefiles_are_read) {
  const TemporaryFolder folder;
  const std::string csv = "name,WKT\na,POINT (1.5 2)\n";
  for (const char* name : {"a.kml", "a.shp", "a.fgb"}) {
    Layer layer(converted(folder, csv, name, "-a_srs EPSG:4326 -oo GEOM_POSSIBLE_NAMES=WKT"), "",
                "");
    Row row;
    ASSERT_TRUE(layer.next(row)) << name;
    EXPECT_EQ(layer.geometry().points.at(0), (Point{1.5, 2})) << name;
    EXPECT_TRUE(layer.crs()->is_wgs84()) << name;
  }
}

TEST(Layer, a_file_that_is_not_what_it_says_is_an_error) {
  const TemporaryFolder folder;
  for (const char* name : {"a.gpkg", "a.shp", "a.fgb", "a.kml", "a.xlsx", "a.ods", "a.xls"}) {
    const std::string file = folder.write(name, "id,x,y\na,1,2\n");
    EXPECT_TRUE(contains(complaint_of([&] { Layer(file, "", ""); }), file + ": ")) << name;
  }
}

TEST(Layer, the_crs_of_geojson_is_that_of_its_member) {
  const TemporaryFolder folder;
  const auto crs_of = [&](const std::string& member) {
    return Layer(folder.write("a.geojson", R"({"type":"FeatureCollection",)" + member +
                                               R"("features":[{"type":"Feature","properties":{},
      "geometry":{"type":"Point","coordinates":[1,2]}}]})"),
                 "", "")
        .crs();
  };
  EXPECT_FALSE(crs_of(""));
  EXPECT_FALSE(crs_of(R"("crs":null,)"));
  EXPECT_EQ(crs_of(R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::32633"}},)")
                ->name(),
            "EPSG:32633");
  EXPECT_TRUE(contains(
      complaint_of([&] {
        crs_of(R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::99999"}},)");
      }),
      "a.geojson: its crs member 'urn:ogc:def:crs:EPSG::99999' is not known to PROJ"));
  EXPECT_TRUE(contains(
      complaint_of([&] { crs_of(R"("crs":{"type":"EPSG","properties":{"code":4326}},)"); }),
      "neither a name nor a link"));
}

TEST(Layer, the_users_environment_has_no_say) {
  // Started before any other GDAL call of this process, these would turn every driver off.
  const TemporaryFolder folder;
  const std::string file = folder.write("a.geojson", R"({"type":"Point","coordinates":[1,2]})");
  setenv("OGR_GEOJSON_MAX_OBJ_SIZE", "0.000001", 1);
  Layer layer(file, "", "");
  Row row;
  const bool first = layer.next(row);
  unsetenv("OGR_GEOJSON_MAX_OBJ_SIZE");
  EXPECT_TRUE(first);
}

}  // namespace
}  // namespace thiessen

#include "files/places/stations_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

StationsRequest request(const std::string& file) {
  StationsRequest wanted;
  wanted.source.file = file;
  return wanted;
}

StationsFile read(const std::string& text, StationsRequest wanted = {},
                  const std::string& name = "s.csv") {
  const TemporaryFolder folder;
  wanted.source.file = folder.write(name, text);
  Warnings warnings;
  return read_stations(wanted, warnings);
}

/// The complaint without the folder's name.
std::vector<std::string> complaints(const std::string& text, const StationsRequest& wanted = {},
                                    const std::string& name = "s.csv") {
  auto sentences = complaints_of([&] { read(text, wanted, name); });
  for (std::string& sentence : sentences) {
    const std::size_t at = sentence.find(name);
    if (at != std::string::npos && sentence.starts_with('/')) sentence.erase(0, at);
  }
  return sentences;
}

std::string points(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

std::string point(const std::string& properties, const std::string& geometry) {
  return R"({"type":"Feature","properties":)" + properties + R"(,"geometry":)" + geometry + "}";
}

TEST(StationsFile, finds_fields_by_name_in_the_contracts_order) {
  const StationsFile file = read("name,LAT,Station,x,lon\nOak,53,007,1,-6.5\n");
  ASSERT_EQ(file.stations.size(), 1U);
  EXPECT_EQ(file.stations[0].id, "007");
  EXPECT_EQ(file.stations[0].position, (Point{-6.5, 53}));
  EXPECT_EQ(file.stations[0].line, 2U);
  EXPECT_TRUE(file.has_lines);
  EXPECT_EQ(file.crs_origin, CrsOrigin::columns);
  EXPECT_TRUE(file.crs->is_wgs84());
}

TEST(StationsFile, takes_the_first_field_for_the_id_where_no_name_tells) {
  const StationsFile file = read("what,easting,northing\n 1,5,6\n");
  EXPECT_EQ(file.stations.at(0).id, "1") << "blanks outside quotes are none of it";
  EXPECT_EQ(file.crs_origin, CrsOrigin::none);
  EXPECT_FALSE(file.crs);
}

TEST(StationsFile, takes_the_fields_that_options_name) {
  StationsRequest wanted;
  wanted.id = "b";
  wanted.x = "U";
  wanted.y = "v";
  const StationsFile file = read("id,b,u,v\n1,2,-0,4\n", wanted);
  EXPECT_EQ(file.stations.at(0).id, "2");
  EXPECT_EQ(file.stations.at(0).position, (Point{0, 4}));
  EXPECT_FALSE(std::signbit(file.stations.at(0).position.x));
  wanted.x = "w";
  EXPECT_EQ(complaints("id,b,u,v\n1,2,3,4\n", wanted).at(0),
            "s.csv:1: 'x': no field 'w'; found 'id', 'b', 'u', 'v'");
}

TEST(StationsFile, reports_every_bad_row) {
  const auto found = complaints(
      "id,x,y\na,1,2\nb,nan,2\nc,1,1e999\nd,0x10,2\ne,,2\na,3,4\n,1,1\nf,\"1,5\",2\ng,2.5,1\n");
  ASSERT_EQ(found.size(), 7U);
  EXPECT_EQ(found[0],
            "s.csv:3: 'x' of station 'b' is missing: 'nan' | 'stations_where' leaves stations out");
  EXPECT_EQ(found[1], "s.csv:4: 'y' of station 'c' is outside the range of numbers: '1e999'");
  EXPECT_EQ(found[2], "s.csv:5: 'x' of station 'd' is no number: '0x10'");
  EXPECT_EQ(found[3], "s.csv:6: 'x' of station 'e' is empty");
  EXPECT_TRUE(
      found[4].starts_with("s.csv:7: station 'a' is already in line 2, at another place | "));
  EXPECT_EQ(found[5], "s.csv:8: a station has no id");
  EXPECT_TRUE(contains(found[6], "'stations_decimal_comma'"));
}

TEST(StationsFile, reports_bad_rows_of_both_kinds) {
  const auto found = complaints("id,x,y\na,1\nb,nan,2\n");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].starts_with("s.csv:2: "));
  EXPECT_TRUE(found[1].starts_with("s.csv:3: "));
}

TEST(StationsFile, reads_decimal_commas_where_told) {
  StationsRequest wanted;
  wanted.source.csv.separator = ';';
  wanted.source.csv.decimal_comma = true;
  EXPECT_EQ(read("id;x;y\na;1,5;-2,25\n", wanted).stations.at(0).position, (Point{1.5, -2.25}));
}

TEST(StationsFile, says_that_there_are_none) {
  const auto found = complaints("id,x,y\n");
  EXPECT_TRUE(found.at(0).starts_with("no stations in /")) << found.at(0);
  StationsRequest wanted;
  wanted.source.where = "x > 5";
  EXPECT_TRUE(contains(complaints("id,x,y\na,1,2\n", wanted).at(0), "pass 'stations_where'"));
}

TEST(StationsFile, keeps_the_ids_that_the_filter_leaves_out) {
  StationsRequest wanted;
  wanted.source.where = "elev >= 100";
  const StationsFile file = read("id,x,y,elev\na,1,2,90\nb,3,4,100\nc,5,bad,20\n", wanted);
  ASSERT_EQ(file.stations.size(), 1U);
  EXPECT_EQ(file.stations[0].id, "b");
  EXPECT_EQ(file.stations[0].line, 3U);
  EXPECT_EQ(file.filtered_ids, (std::unordered_set<std::string>{"a", "c"}));
}

TEST(StationsFile, carries_attributes_with_their_types) {
  StationsRequest wanted;
  wanted.attributes = true;
  const StationsFile file =
      read("id,x,y,elev,h,code,note\na,1,2,90,1.5,007,\nb,3,4,-3,2,010,é\n", wanted);
  ASSERT_EQ(file.attributes.fields.size(), 7U);
  EXPECT_EQ(file.attributes.fields[3].type, FieldType::integer);
  EXPECT_EQ(file.attributes.fields[4].type, FieldType::real);
  EXPECT_EQ(file.attributes.fields[5].type, FieldType::text);
  EXPECT_EQ(file.attributes.rows.at(1).at(6), "é");
}

TEST(StationsFile, reads_points_of_a_wkt_column) {
  EXPECT_EQ(read("id,WKT\na,POINT (1.5 2)\n").stations.at(0).position, (Point{1.5, 2}));
  const auto found =
      complaints("id,wkt\na,POINT (1.5\nb,\nc,\"LINESTRING (0 0,1 1)\"\nd,POINT EMPTY\n");
  ASSERT_EQ(found.size(), 4U);
  EXPECT_TRUE(contains(found[0], "s.csv:2: not a geometry in WKT"));
  EXPECT_EQ(found[1],
            "s.csv:3: station 'b' has no geometry | 'skip_unplaced' passes over stations without "
            "coordinates");
  EXPECT_EQ(found[2],
            "s.csv:4: station 'c' is a LineString, and not a point | 'stations_where' leaves "
            "stations out");
  EXPECT_EQ(found[3], "s.csv:5: station 'd' has an empty geometry");
}

TEST(StationsFile, joins_rows_that_repeat_a_station_at_its_place) {
  const TemporaryFolder folder;
  Warnings warnings;
  const std::string file =
      folder.write("s.csv", "station,date,lat,lon\na,1,2,3\nb,1,4,5\na,2,2.0,3\nb,2,4,5e0\n");
  const StationsFile read = read_stations(request(file), warnings);
  ASSERT_EQ(read.stations.size(), 2U);
  EXPECT_EQ(read.stations[0].line, 2U);
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            file + ": 2 rows repeat a station at its place: they make 2 stations");
}

TEST(StationsFile, numbers_points_that_have_nothing_to_be_called_by) {
  EXPECT_EQ(read("lon,lat\n1,2\n3,4\n").stations.at(1).id, "2");
  EXPECT_EQ(read("rain,lon,lat\n12,1,2\n").stations.at(0).id, "1") << "rain is no name";
  EXPECT_EQ(read("WKT\nPOINT (1 2)\n").stations.at(0).id, "1");
  EXPECT_EQ(read("lon,lat,what\n1,2,x\n").stations.at(0).id, "x");
  StationsRequest wanted;
  wanted.source.where = "lon > 1";
  const StationsFile file = read("lon,lat\n1,2\n3,4\n", wanted);
  EXPECT_EQ(file.stations.at(0).id, "2") << "the number is the file's";
  EXPECT_EQ(file.filtered_ids, (std::unordered_set<std::string>{"1"}));
  EXPECT_EQ(read(points(point("{}", R"({"type":"Point","coordinates":[1,2]})")), {}, "s.geojson")
                .stations.at(0)
                .id,
            "1");
}

TEST(StationsFile, passes_over_stations_without_coordinates_where_told) {
  StationsRequest wanted;
  wanted.skip_unplaced = true;
  const TemporaryFolder folder;
  wanted.source.file = folder.write("s.csv", "id,x,y\na,1,2\nb,,\nc, ,\n");
  Warnings warnings;
  const StationsFile file = read_stations(wanted, warnings);
  EXPECT_EQ(file.stations.size(), 1U);
  EXPECT_EQ(file.filtered_ids, (std::unordered_set<std::string>{"b", "c"}));
  EXPECT_EQ(
      sentences_of(warnings),
      (std::vector<std::string>{wanted.source.file +
                                ": 2 stations without coordinates are passed over: 'b', 'c'"}));
  EXPECT_EQ(complaints("id,x,y\na,1,2\nb,,3\n", wanted).at(0),
            "s.csv:3: 'x' of station 'b' is empty | 'stations_where' leaves stations out")
      << "half a coordinate is a fault";
  EXPECT_EQ(
      complaints("id,x,y\na,1,2\nb,,\n").at(0),
      "s.csv:3: station 'b' has no coordinates | 'skip_unplaced' passes over stations without "
      "coordinates");
  EXPECT_EQ(read("id,wkt\na,POINT (1 2)\nb,\nc,POINT EMPTY\n", wanted).stations.size(), 1U);
}

TEST(StationsFile, reads_degrees_minutes_and_seconds) {
  const TemporaryFolder folder;
  Warnings warnings;
  const std::string file =
      folder.write("s.csv", "id,lon,lat\na,10:30,47 15\nb,5d30'W,\"47°15'0\"\"S\"\n");
  const StationsFile read = read_stations(request(file), warnings);
  ASSERT_EQ(read.stations.size(), 2U);
  EXPECT_EQ(read.stations[0].position, (Point{10.5, 47.25}));
  EXPECT_EQ(read.stations[1].position, (Point{-5.5, -47.25}));
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].sentence(),
            file + ": coordinates in degrees, minutes and seconds are read: '10:30' for 10.5");
}

TEST(StationsFile, takes_letters_for_degrees) {
  EXPECT_TRUE(read("id,x,y\na,10:30E,47 15N\n").crs->is_wgs84());
}

TEST(StationsFile, knows_the_crs_that_geometries_name) {
  const StationsFile file = read("id,geom\na,SRID=25832;POINT (500000 5e6)\n");
  EXPECT_EQ(file.crs->name(), "EPSG:25832");
  EXPECT_EQ(file.crs_origin, CrsOrigin::file);
  EXPECT_EQ(complaints("id,geom\na,SRID=4326;POINT (1 2)\nb,SRID=25832;POINT (1 2)\n").at(0),
            "s.csv:3: its SRID is 25832, and others' before it 4326 | a file's geometries have one "
            "CRS");
}

TEST(StationsFile, reads_geojson) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "s.geojson",
      points(point(R"({"id":"007","day":"2010-01-02","n":12345678901234567,"h":0.1})",
                   R"({"type":"Point","coordinates":[0.1,2,77]})") +
             "," + point(R"({"id":"8"})", R"({"type":"MultiPoint","coordinates":[[3,4]]})")));
  Warnings warnings;
  StationsRequest wanted = request(file);
  wanted.attributes = true;
  const StationsFile read = read_stations(wanted, warnings);
  ASSERT_EQ(read.stations.size(), 2U);
  EXPECT_EQ(read.stations[0].id, "007");
  EXPECT_EQ(read.stations[0].position, (Point{0.1, 2}));
  EXPECT_EQ(read.stations[1].position, (Point{3, 4}));
  EXPECT_EQ(read.attributes.rows.at(0),
            (std::vector<std::string>{"007", "2010-01-02", "12345678901234567", "0.1"}));
  EXPECT_EQ(read.attributes.fields.at(2).type, FieldType::integer);
  EXPECT_EQ(read.crs_origin, CrsOrigin::implied);
  EXPECT_FALSE(read.has_lines);
  EXPECT_EQ(sentences_of(warnings),
            (std::vector<std::string>{file + ": heights (Z) are passed over"}));
}

TEST(StationsFile, names_the_path_of_a_bad_feature) {
  const auto found = complaints(
      points(point(R"({"id":"a"})", "null") + "," +
             point(R"({"id":"b"})", R"({"type":"MultiPoint","coordinates":[[1,2],[3,4]]})")),
      {}, "s.geojson");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0],
            "s.geojson: features[0].geometry: station 'a' has no geometry | 'skip_unplaced' passes "
            "over stations without coordinates");
  EXPECT_EQ(
      found[1],
      "s.geojson: features[1].geometry: station 'b' has more than one point | 'stations_where' "
      "leaves stations out");
}

TEST(StationsFile, the_crs_of_option_and_file_must_agree) {
  StationsRequest wanted;
  wanted.source.crs = "EPSG:32633";
  EXPECT_EQ(read("id,x,y\na,1,2\n", wanted).crs_origin, CrsOrigin::option);
  const std::string named =
      R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":
    "urn:ogc:def:crs:EPSG::4326"}},"features":[)" +
      point(R"({"id":"a"})", R"({"type":"Point","coordinates":[1,2]})") + "]}";
  EXPECT_TRUE(contains(complaints(named, wanted, "s.geojson").at(0),
                       "its CRS is EPSG:4326, and not EPSG:32633"));
  wanted.source.crs = "OGC:CRS84";
  const StationsFile file = read(named, wanted, "s.geojson");
  EXPECT_EQ(file.crs_origin, CrsOrigin::file);
  EXPECT_EQ(file.stations.at(0).position, (Point{1, 2}));
}

TEST(StationsFile, a_crs_link_is_not_followed) {
  const std::string linked =
      R"({"type":"FeatureCollection","crs":{"type":"link","properties":{"href":
    "http://127.0.0.1:9/crs","type":"proj4"}},"features":[)" +
      point(R"({"id":"a"})", R"({"type":"Point","coordinates":[1,2]})") + "]}";
  const TemporaryFolder folder;
  Warnings warnings;
  const StationsFile file = read_stations(request(folder.write("s.geojson", linked)), warnings);
  EXPECT_EQ(file.crs_origin, CrsOrigin::implied);
  ASSERT_EQ(warnings.messages().size(), 1U);
  EXPECT_TRUE(contains(warnings.messages()[0].text.plain(), "never followed"));
}

}  // namespace
}  // namespace thiessen

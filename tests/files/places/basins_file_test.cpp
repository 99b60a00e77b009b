#include "files/places/basins_file.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

BasinsFile read(const std::string& text, BasinsRequest wanted = {},
                const std::string& name = "b.geojson") {
  const TemporaryFolder folder;
  wanted.source.file = folder.write(name, text);
  wanted.source.where_setting = "basins_where";
  Warnings warnings;
  return read_basins(wanted, warnings);
}

std::vector<std::string> complaints(const std::string& text, const BasinsRequest& wanted = {},
                                    const std::string& name = "b.geojson") {
  auto sentences = complaints_of([&] { read(text, wanted, name); });
  for (std::string& sentence : sentences) sentence.erase(0, sentence.find(name));
  return sentences;
}

std::string collection(const std::vector<std::string>& properties,
                       const std::string& geometry =
                           R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})") {
  std::string text = R"({"type":"FeatureCollection","features":[)";
  for (const std::string& each : properties) {
    if (text.back() != '[') text += ',';
    text += R"({"type":"Feature","properties":)" + each + R"(,"geometry":)" + geometry + "}";
  }
  return text + "]}";
}

std::vector<std::string> ids(const BasinsFile& file) {
  std::vector<std::string> all;
  for (const RawBasin& basin : file.basins) all.push_back(basin.id);
  return all;
}

using Ids = std::vector<std::string>;

TEST(BasinsFile, the_first_field_whose_values_are_there_and_differ_is_the_id) {
  EXPECT_EQ(ids(read(collection({R"({"name":"A","id":"01","basin":"x"})",
                                 R"({"name":"B","id":"02","basin":"x"})"}))),
            (Ids{"01", "02"}));
  EXPECT_EQ(ids(read(collection({R"({"name":"A","ID":"01"})", R"({"name":"B","ID":null})"}))),
            (Ids{"A", "B"}));
  EXPECT_EQ(ids(read(collection({R"({"name":"A"})", R"({"name":"A"})"}))), (Ids{"1", "2"}));
  EXPECT_EQ(ids(read(collection({R"({"other":"A"})"}))), (Ids{"1"}));
}

TEST(BasinsFile, features_that_share_the_named_field_are_one_basin) {
  BasinsRequest wanted;
  wanted.id = "River";
  const BasinsFile file =
      read(collection({R"({"river":"B"})", R"({"river":"A"})", R"({"river":"B"})"}), wanted);
  EXPECT_EQ(ids(file), (Ids{"B", "A"}));
  EXPECT_EQ(file.basins[0].polygons.size(), 2U);
  EXPECT_EQ(complaints(collection({R"({"river":"B"})", R"({"river":null})"}), wanted).at(0),
            "b.geojson: features[1].geometry: basin has no 'River'");
}

TEST(BasinsFile, names_every_feature_that_is_no_area) {
  EXPECT_EQ(complaints(collection({R"({"name":"A"})"}, "null")).at(0),
            "b.geojson: features[0].geometry: basin 'A' has no geometry | 'basins_where' leaves "
            "features out");
  EXPECT_EQ(
      complaints(collection({R"({"name":"A"})"}, R"({"type":"Point","coordinates":[1,2]})")).at(0),
      "b.geojson: features[0].geometry: basin 'A' is a Point, and not a polygon | 'basins_where' "
      "leaves features out");
  EXPECT_EQ(complaints(collection({R"({"a":"A"})"},
                                  R"({"type":"LineString","coordinates":[[1,2],[3,4]]})"))
                .at(0),
            "b.geojson: features[0].geometry: basin is a LineString, and not a polygon | "
            "'basins_where' leaves features out");
  EXPECT_EQ(complaints(collection({"{}"}, R"({"type":"GeometryCollection","geometries":[
              {"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}]})"))
                .at(0),
            "b.geojson: features[0].geometry: basin is a GeometryCollection, and not a polygon | "
            "'basins_where' leaves features out");
  EXPECT_EQ(
      complaints(collection({R"({"name":"A"})"}, R"({"type":"Polygon","coordinates":[]})")).at(0),
      "b.geojson: features[0].geometry: basin 'A' has no geometry | 'basins_where' leaves features "
      "out");
}

TEST(BasinsFile, says_that_there_are_none) {
  EXPECT_TRUE(contains(complaint_of([] { read(collection({})); }), "no basins in /"));
  BasinsRequest wanted;
  wanted.source.where = "name = 'B'";
  EXPECT_TRUE(contains(complaint_of([&] { read(collection({R"({"name":"A"})"}), wanted); }),
                       "pass 'basins_where'"));
}

TEST(BasinsFile, the_number_of_a_feature_counts_those_filtered_out) {
  BasinsRequest wanted;
  wanted.source.where = "kind = 2";
  EXPECT_EQ(ids(read(collection({R"({"kind":1})", R"({"kind":2})"}), wanted)), (Ids{"2"}));
}

TEST(BasinsFile, T066_is_never_read_that_ends_anywhere_in_the_middle) {
  const std::string whole = collection({R"({"id":"a"})", R"({"id":"b"})"});
  EXPECT_EQ(ids(read(whole)), (Ids{"a", "b"}));
  for (std::size_t cut = 0; cut < whole.size(); ++cut)
    EXPECT_THROW(read(whole.substr(0, cut)), Error) << cut << " bytes";
}

TEST(BasinsFile, reads_wkt_from_a_csv) {
  const BasinsFile file = read("id,WKT\na,\"POLYGON ((0 0,1 0,1 1,0 0))\"\n", {}, "b.csv");
  EXPECT_EQ(ids(file), (Ids{"a"}));
  EXPECT_EQ(file.basins[0].line, 2U);
  EXPECT_EQ(file.crs_origin, CrsOrigin::none);
  EXPECT_EQ(complaints("id,WKT\na,\"POLYGON ((0 0,1 0\"\n", {}, "b.csv").at(0),
            "b.csv:2: not a geometry in WKT: 'POLYGON ((0 0,1 0'");
  EXPECT_TRUE(contains(
      complaints("id,WKT\na,\"POLYGON ((0 0,nan 0,1 1,0 0))\"\n", {}, "b.csv").at(0), "b.csv:2: "));
  EXPECT_TRUE(contains(complaints("id,x,y\na,1,2\n", {}, "b.csv").at(0), "holds no polygons"));
}

}  // namespace
}  // namespace thiessen

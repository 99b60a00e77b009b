#include "text/geojson_audit.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "text/text_bytes.h"

namespace thiessen {
namespace {

using CrsMember = GeoJsonFindings::CrsMember;

GeoJsonFindings audit(const std::string& text) {
  TextBytes bytes(text);
  return audit_geojson("b.geojson", bytes);
}

std::string complaint(const std::string& text) {
  return complaint_of([&] { audit(text); });
}

std::string collection(const std::string& features, const std::string& more = "") {
  return R"({"type":"FeatureCollection",)" + more + R"("features":[)" + features + "]}";
}

std::string feature(const std::string& geometry) {
  return R"({"type":"Feature","properties":{"id":1},"geometry":)" + geometry + "}";
}

std::string polygon(const std::string& coordinates) {
  return feature(R"({"type":"Polygon","coordinates":)" + coordinates + "}");
}

const std::string square = polygon("[[[0,0],[1,0],[1,1],[0,0]]]");

TEST(GeoJsonAudit, counts_the_features) {
  EXPECT_EQ(audit(collection(square + "," + square)).features, 2U);
  EXPECT_EQ(audit(collection("")).features, 0U);
  EXPECT_EQ(audit(square).features, 1U);
  EXPECT_EQ(audit(R"({"type":"Point","coordinates":[1,2]})").features, 1U);
  EXPECT_EQ(audit("\xEF\xBB\xBF" + collection(square)).features, 1U);
}

TEST(GeoJsonAudit, sees_which_crs_member_there_is) {
  EXPECT_EQ(audit(collection(square)).crs, CrsMember::absent);
  EXPECT_EQ(audit(collection(square, R"("crs":null,)")).crs, CrsMember::null);
  EXPECT_EQ(audit(collection(square, R"("crs":{"type":"name","properties":{"name":"x"}},)")).crs,
            CrsMember::name);
  EXPECT_EQ(audit(collection(square, R"("crs":{"properties":{"type":"name"},"type":"link"},)")).crs,
            CrsMember::link);
  EXPECT_EQ(audit(collection(square, R"("crs":{"type":"EPSG"},)")).crs, CrsMember::other);
  EXPECT_EQ(audit(collection(feature(R"({"crs":null,"type":"Point","coordinates":[1,2]})"))).crs,
            CrsMember::absent);
}

TEST(GeoJsonAudit, names_the_path_of_every_bad_coordinate) {
  const auto complaints = complaints_of([] {
    audit(collection(square + "," + polygon(R"([[[0,1e999],["x",0],[null,1],[{},0],[true,0]]])")));
  });
  ASSERT_EQ(complaints.size(), 5U);
  EXPECT_EQ(
      complaints[0],
      "b.geojson: features[1].geometry.coordinates[0][0][1]: '1e999' is outside a double's range");
  EXPECT_EQ(
      complaints[1],
      "b.geojson: features[1].geometry.coordinates[0][1][0]: a text stands where a number should");
  EXPECT_EQ(complaints[2],
            "b.geojson: features[1].geometry.coordinates[0][2][0]: 'null' is no number");
  EXPECT_EQ(complaints[4],
            "b.geojson: features[1].geometry.coordinates[0][4][0]: 'true' is no number");
}

TEST(GeoJsonAudit, takes_no_word_for_a_number) {
  for (const char* word : {"NaN", "Infinity", "nan", "inf"}) {
    EXPECT_TRUE(contains(complaint(collection(polygon("[[[0," + std::string(word) + "]]]"))),
                         "features[0].geometry.coordinates[0][0][1]"))
        << word;
  }
  EXPECT_TRUE(contains(complaint(collection(polygon("[[[0,-Infinity]]]"))), "line 1") ||
              contains(complaint(collection(polygon("[[[0,-Infinity]]]"))), "is no number"));
}

TEST(GeoJsonAudit, counts_the_brackets_of_each_type) {
  EXPECT_TRUE(
      contains(complaint(collection(polygon("[[0,0],[1,0],[1,1]]"))), "features[0].geometry: "));
  EXPECT_TRUE(contains(complaint(collection(polygon("[[[0],[1,0]]]"))), "two numbers"));
  EXPECT_TRUE(contains(complaint(collection(polygon("[[[[0,0]]]]"))), "nested"));
  const std::string corner = "features[0].geometry.coordinates[0][1]";
  EXPECT_TRUE(contains(complaint(collection(polygon("[[[0,0],[0,[1,2]],[1,1]]]"))),
                       corner + "[1]: lies in more or fewer brackets"));
  EXPECT_TRUE(contains(complaint(collection(polygon("[[[0,[1,2]]]]"))), "a list stands beside"));
  EXPECT_TRUE(contains(complaint(collection(polygon("{}"))), "list"));
  EXPECT_TRUE(
      contains(complaint(collection(feature(R"({"type":"Polygon"})"))), "without coordinates"));
  EXPECT_TRUE(contains(complaint(collection(feature(R"({"type":"Circle"})"))), "'Circle'"));
  EXPECT_EQ(audit(collection(polygon("[[[0,0,5],[1,0,5,7]]]"))).features, 1U);
  EXPECT_EQ(audit(collection(polygon("[]"))).features, 1U);
  EXPECT_EQ(audit(collection(feature("null"))).features, 1U);
}

TEST(GeoJsonAudit, leaves_properties_alone) {
  EXPECT_EQ(audit(collection(R"({"type":"Feature","properties":{"coordinates":["x"],"crs":null,
    "deep":{"type":"Polygon","coordinates":"none"}},"geometry":null})"))
                .crs,
            CrsMember::absent);
}

TEST(GeoJsonAudit, refuses_every_truncation) {
  const std::string whole = collection(square + "," + square, R"("name":"\u00e9\ud83d\ude00 \n",)");
  EXPECT_EQ(audit(whole).features, 2U);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    EXPECT_NE(complaint(whole.substr(0, length)), "") << length;
  }
}

TEST(GeoJsonAudit, refuses_what_is_not_json) {
  EXPECT_TRUE(contains(complaint(collection(square) + "x"), "after the end"));
  EXPECT_TRUE(contains(complaint(collection(square) + collection(square)), "after the end"));
  EXPECT_TRUE(contains(complaint("\x1e" + collection(square)), "expected"));
  EXPECT_TRUE(contains(complaint("// a\n" + collection(square)), "b.geojson:1: "));
  EXPECT_TRUE(contains(complaint(collection("\n\n" + square + ",")), "b.geojson:3: "));
  EXPECT_TRUE(contains(complaint(R"({"type":"\x"})"), "escape"));
  EXPECT_TRUE(contains(complaint(R"({"type":"\ud800"})"), "surrogate"));
  EXPECT_TRUE(contains(complaint("{\"type\":\"a\nb\"}"), "control character"));
  EXPECT_TRUE(contains(complaint("{\"type\":\"\xC0\x80\"}"), "not UTF-8 at byte"));
  EXPECT_TRUE(contains(complaint("{\"type\":\"\xED\xA0\x80\"}"), "not UTF-8 at byte"));
  EXPECT_TRUE(contains(complaint(R"({"type":"Feature","type":"Feature"})"), "given twice"));
  EXPECT_TRUE(contains(complaint(R"({"type":"Point","coordinates":[01,2]})"), "no number"));
  EXPECT_TRUE(contains(complaint(R"({"type":"Point","coordinates":[1.,2]})"), "no number"));
  EXPECT_TRUE(contains(complaint("{'type':'Point'}"), "expected"));
  EXPECT_TRUE(contains(complaint(R"({"type":"Topology","objects":{}})"), "'Topology'"));
  EXPECT_TRUE(contains(complaint(R"({"type":"FeatureCollection"})"), "without features"));
}

TEST(GeoJsonAudit, survives_hostile_depth) {
  EXPECT_TRUE(contains(complaint(R"({"a":)" + std::string(200000, '[')), "nest"));
  EXPECT_TRUE(contains(complaint(R"({"type":"Polygon","coordinates":)" + std::string(200000, '[')),
                       "nests"));
}

TEST(GeoJsonAudit, says_the_same_wherever_its_bytes_are_parted) {
  const std::string text = "\xEF\xBB\xBF" + collection(square);
  for (std::size_t piece = 1; piece <= text.size(); ++piece) {
    TextBytes bytes(text, piece);
    EXPECT_EQ(audit_geojson("b.geojson", bytes).features, 1U) << "in pieces of " << piece;
  }
}

// GDAL's time grows with the square of the number of names.
TEST(GeoJsonAudit, bounds_how_many_names_properties_have_in_one_feature_or_in_all) {
  const auto with = [](std::size_t first, std::size_t count) {
    std::string properties;
    for (std::size_t i = first; i < first + count; ++i)
      properties += (properties.empty() ? "\"p" : ",\"p") + std::to_string(i) + "\":1";
    return R"({"type":"Feature","properties":{)" + properties +
           R"(},"geometry":{"type":"Point","coordinates":[1,2]}})";
  };
  const std::string most = with(0, 10'000);
  EXPECT_EQ(audit(collection(most + "," + most)).features, 2U);
  const std::string fault = "features have more than 10,000 different properties";
  EXPECT_NE(complaint(collection(with(0, 10'001))).find(fault), std::string::npos);
  EXPECT_NE(complaint(with(0, 10'001)).find(fault), std::string::npos);
  EXPECT_NE(complaint(collection(most + "," + with(10'000, 1))).find(fault), std::string::npos);
}

}  // namespace
}  // namespace thiessen

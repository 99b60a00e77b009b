#include "files/tables/features.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "base/temporary_folder.h"

namespace thiessen {
namespace {

using Texts = std::vector<std::string>;
constexpr std::size_t longest_field = 1 << 20;

/// A file of features that is opened with what the user says of it.
struct Opened {
  Opened(const std::string& name, const std::string& text, Source said = {})
      : source(std::move(said)), features(with_file(name, text), longest_field, warnings) {}

  Source with_file(const std::string& name, const std::string& text) {
    source.file = folder.write(name, text);
    return source;
  }
  /// The first field of all features that are kept.
  Texts kept() {
    Texts ids;
    Complaints complaints;
    while (features.next(complaints)) {
      if (features.kept()) ids.emplace_back(features.row().fields[0]);
    }
    complaints.throw_if_any();
    return ids;
  }

  TemporaryFolder folder;
  Source source;
  Warnings warnings;
  Features features;
};

Source where(const std::string& filter) {
  Source source;
  source.where = filter;
  return source;
}

Source with_crs(const std::string& crs) {
  Source source;
  source.crs = crs;
  return source;
}

std::string point(const std::string& properties, const std::string& crs = "") {
  return R"({"type":"FeatureCollection",)" + crs +
         R"("features":[{"type":"Feature","properties":)" + properties +
         R"(,"geometry":{"type":"Point","coordinates":[1,2]}}]})";
}

std::string crs_member(const std::string& code) {
  return R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::)" + code + "\"}},";
}

TEST(Features, of_a_csv_are_its_rows_with_their_lines) {
  Opened csv("s.csv", "\nid,x\na,1\nb,2\n");
  EXPECT_EQ(csv.features.header(), (Texts{"id", "x"}));
  EXPECT_TRUE(csv.features.has_lines());
  EXPECT_EQ(csv.features.header_line(), 2U);
  EXPECT_FALSE(csv.features.has_geometry());
  EXPECT_EQ(csv.features.type(1), FieldType::text);
  Complaints complaints;
  ASSERT_TRUE(csv.features.next(complaints));
  EXPECT_EQ(csv.features.place(), "");
  EXPECT_EQ(csv.features.message("is odd", "so be it").sentence(), csv.source.file + ":3: is odd");
  EXPECT_EQ(csv.kept(), Texts{"b"});
}

TEST(Features, of_geojson_are_named_by_their_path) {
  Opened json("b.geojson", point(R"({"id":"a","n":5})"));
  EXPECT_FALSE(json.features.has_lines());
  EXPECT_TRUE(json.features.has_geometry());
  EXPECT_EQ(json.features.type(1), FieldType::integer);
  Complaints complaints;
  ASSERT_TRUE(json.features.next(complaints));
  EXPECT_EQ(json.features.place(), "features[0].geometry");
  EXPECT_EQ(json.features.message("is odd").sentence(),
            json.source.file + ": features[0].geometry: is odd");
  EXPECT_EQ(json.features.geometry().points.at(0), (Point{1, 2}));
}

TEST(Features, of_a_csv_have_the_geometry_of_a_column_called_wkt) {
  Opened csv("b.csv", "id,Wkt\na,POINT (3 4)\nb,nonsense\n");
  EXPECT_TRUE(csv.features.has_geometry());
  Complaints complaints;
  ASSERT_TRUE(csv.features.next(complaints));
  EXPECT_EQ(csv.features.geometry().points.at(0), (Point{3, 4}));
  ASSERT_TRUE(csv.features.next(complaints));
  EXPECT_EQ(complaint_of([&] { csv.features.geometry(); }),
            csv.source.file + ":3: not a geometry in WKT: 'nonsense'");
}

TEST(Features, a_filter_keeps_some_and_compares_by_what_the_texts_of_a_csv_stand_for) {
  const std::string text = "id,n,code\na,9,007\nb,10,7\nc,,7\n";
  EXPECT_EQ(Opened("s.csv", text, where("n > 9")).kept(), Texts{"b"}) << "as numbers";
  EXPECT_EQ(Opened("s.csv", text, where("code = '7'")).kept(), (Texts{"b", "c"})) << "as texts";
  EXPECT_EQ(Opened("s.csv", text, where("n IS NULL")).kept(), Texts{"c"});
  EXPECT_EQ(Opened("s.geojson", point(R"({"id":"a","n":5})"), where("n > 5")).kept(), Texts{});
}

TEST(Features, rows_that_cannot_be_read_are_told_at_the_end_with_a_filter_or_without) {
  for (const char* filter : {"", "x > 0"}) {
    Opened csv("s.csv", "id,x\na,1\nb\nc,3\n", where(filter));
    Texts ids;
    Complaints complaints;
    while (csv.features.next(complaints)) ids.emplace_back(csv.features.row().fields[0]);
    EXPECT_EQ(ids, (Texts{"a", "c"}));
    EXPECT_EQ(complaint_of([&] { complaints.throw_if_any(); }),
              csv.source.file + ":3: row has 1 field, the header has 2");
  }
}

TEST(Features, a_csv_has_no_layers) {
  Source source;
  source.layer = "first";
  EXPECT_TRUE(complaint_of([&] {
                Opened("s.csv", "id\na\n", source);
              }).ends_with("a CSV file has no layers: stations_layer = first"));
}

TEST(Features, numbers_of_a_csv_alone_may_have_a_decimal_comma) {
  Source source;
  source.csv.decimal_comma = true;
  EXPECT_EQ(Opened("s.csv", "id\na\n", source).features.decimal_mark(), DecimalMark::comma);
  EXPECT_EQ(Opened("s.csv", "id\na\n").features.decimal_mark(), DecimalMark::point);
  EXPECT_EQ(Opened("s.geojson", point("{}"), source).features.decimal_mark(), DecimalMark::point);
}

TEST(FeaturesCrs, is_what_the_option_or_the_file_or_rfc_7946_says) {
  const auto named = [](const std::string& name, const std::string& text, const Source& source) {
    return Opened(name, text, source).features.crs();
  };
  EXPECT_FALSE(named("s.csv", "id\na\n", {}).crs);
  const auto by_option = named("s.csv", "id\na\n", with_crs("EPSG:32633"));
  EXPECT_EQ(by_option.crs->name(), "EPSG:32633");
  EXPECT_TRUE(by_option.by_option);
  const auto by_file = named("s.geojson", point("{}", crs_member("32633")), {});
  EXPECT_EQ(by_file.crs->name(), "EPSG:32633");
  EXPECT_FALSE(by_file.by_option || by_file.implied);
  const auto implied = named("s.geojson", point("{}"), {});
  EXPECT_TRUE(implied.crs->is_wgs84());
  EXPECT_TRUE(implied.implied);
  const auto over_implied = named("s.geojson", point("{}"), with_crs("EPSG:32633"));
  EXPECT_EQ(over_implied.crs->name(), "EPSG:32633");
  EXPECT_FALSE(over_implied.implied);
}

TEST(FeaturesCrs, two_of_one_file_are_an_error_unless_they_are_the_same) {
  Opened other("s.geojson", point("{}", crs_member("32633")), with_crs("EPSG:32632"));
  EXPECT_TRUE(contains(complaint_of([&] { other.features.crs(); }),
                       "its CRS is EPSG:32633, and not EPSG:32632 as 'crs' says"));
  Opened same("s.geojson", point("{}", crs_member("32633")),
              with_crs("+proj=utm +zone=33 +datum=WGS84"));
  EXPECT_FALSE(same.features.crs().by_option) << "the file says it already";
}

}  // namespace
}  // namespace thiessen

#include "cli/outputs/rasters/raster_style.h"

#include <gtest/gtest.h>

#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace thiessen::cli {
namespace {

bool differ(const Colour& a, const Colour& b) {
  return std::tie(a.red, a.green, a.blue) != std::tie(b.red, b.green, b.blue);
}

TEST(StationStyle, neighbours_differ_across_rows_and_across_what_is_noted_at_once) {
  StationStyle style({"A", "B", "C", "D"}, 3);
  style.note(std::vector<std::int32_t>{1, 2, 2, 1, 2, 0});
  style.note(std::vector<std::int32_t>{3, 3, 4});
  const auto colours = style.colours();
  ASSERT_EQ(colours.size(), 4u);
  EXPECT_TRUE(differ(colours[0], colours[1])) << "beside each other";
  EXPECT_TRUE(differ(colours[0], colours[2])) << "above each other, noted apart";
  EXPECT_TRUE(differ(colours[1], colours[2]));
  EXPECT_TRUE(differ(colours[2], colours[3]));
}

TEST(StationStyle, its_file_lies_beside_the_raster_and_has_who_owns_a_pixel) {
  StationStyle style({"A", "no pixel", "C"}, 2);
  style.note(std::vector<std::int32_t>{1, 3});
  style.colours();
  const EncodedFile file = style.file("a.b/map.tif");
  EXPECT_EQ(file.name, "a.b/map.qml");
  EXPECT_NE(file.bytes.find("value=\"1\" label=\"A\""), std::string::npos);
  EXPECT_NE(file.bytes.find("value=\"3\" label=\"C\""), std::string::npos);
  EXPECT_EQ(file.bytes.find("no pixel"), std::string::npos);
}

TEST(StationStyle, of_thousands_follows_their_numbers) {
  const std::size_t most = StationStyle::most_chosen;
  std::vector<std::int32_t> row(most + 1);
  for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<std::int32_t>(i + 1);
  StationStyle all(std::vector<std::string>(most + 1, "id"), static_cast<int>(most + 1));
  all.note(row);
  EXPECT_EQ(all.owners(), most + 1);
  EXPECT_TRUE(all.colours().empty());
  EXPECT_NE(all.file("map.tif").bytes.find("INTERPOLATED"), std::string::npos);
  row.back() = 0;
  StationStyle some(std::vector<std::string>(most + 1, "id"), static_cast<int>(most + 1));
  some.note(row);
  EXPECT_EQ(some.colours().size(), most + 1) << "one owns no pixel";
  EXPECT_NE(some.file("map.tif").bytes.find("paletted"), std::string::npos);
}

ClassRule breaks_of(std::vector<double> breaks) {
  ClassRule rule;
  rule.kind = ClassRule::Kind::breaks;
  rule.breaks = std::move(breaks);
  return rule;
}

// As a raster of floats holds them: the float before 2, and before 5.
TEST(RainfallStyle, classes_reach_from_bound_to_bound_without_gaps) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> readings{8, none, 0, 0.25, 3};
  const RainfallStyle style(RainfallClasses(readings, breaks_of({2, 5, 7})), readings, "mm");
  const auto& classes = style.classes();
  ASSERT_EQ(classes.size(), 5u) << "dry, and four of which one has no reading";
  EXPECT_EQ(classes[0].low, 0);
  EXPECT_EQ(classes[0].high, 0);
  EXPECT_EQ(classes[1].low, 0);
  EXPECT_EQ(classes[1].high, 1.9999998807907104);
  EXPECT_EQ(classes[2].low, 2);
  EXPECT_EQ(classes[2].high, 4.999999523162842);
  EXPECT_EQ(classes[3].low, 5);
  EXPECT_EQ(classes[4].low, 7);
  EXPECT_EQ(classes[4].high, 8) << "the largest, for the class has no end";
  for (std::size_t i = 1; i < classes.size(); ++i)
    EXPECT_TRUE(differ(classes[i].colour, classes[i - 1].colour));
}

TEST(RainfallStyle, classes_of_quantiles_and_of_a_range_reach_over_all_values) {
  ClassRule range;
  range.range = ClassRule::Range{10, 20};
  const std::vector<double> readings{4, 12, 18, 26};
  const auto of_range = RainfallStyle(RainfallClasses(readings, range), readings, "").classes();
  EXPECT_EQ(of_range.front().low, 4);
  EXPECT_EQ(of_range.back().high, 26);
  const std::vector<double> skewed{1.3, 1.4, 2.5, 3.6, 99.5};
  const auto of_skewed = RainfallStyle(RainfallClasses(skewed, {}), skewed, "").classes();
  EXPECT_EQ(of_skewed.front().low, 1) << "where the legend begins";
  EXPECT_EQ(of_skewed.back().high, 100);
}

// The float nearest to 0.7 is less than 0.7, and is what the raster holds of a reading of 0.7; that
// nearest to 0.3 is more.
TEST(RainfallStyle, a_reading_at_a_bound_is_of_the_class_above_as_the_raster_holds_it) {
  const std::vector<double> readings{0.1, 0.3, 0.7, 1};
  const auto classes =
      RainfallStyle(RainfallClasses(readings, breaks_of({0.3, 0.7})), readings, "mm").classes();
  ASSERT_EQ(classes.size(), 3u);
  EXPECT_LT(classes[0].high, static_cast<double>(0.3F));
  EXPECT_EQ(classes[1].low, 0.3);
  EXPECT_LT(classes[1].high, static_cast<double>(0.7F));
  EXPECT_GT(classes[2].low, classes[1].high);
  EXPECT_NEAR(classes[2].low, static_cast<double>(0.7F), 1e-14);
  EXPECT_LT(classes[2].low, static_cast<double>(0.7F)) << "by more than GDAL's digits leave out";
}

TEST(RainfallStyle, one_value_has_few_digits) {
  const std::vector<double> reading{20.8 / 3};
  const RainfallStyle style(RainfallClasses(reading, {}), reading, "mm");
  ASSERT_EQ(style.classes().size(), 1u);
  EXPECT_LE(style.classes()[0].low, static_cast<double>(static_cast<float>(reading[0])));
  EXPECT_GT(style.classes()[0].high, static_cast<double>(static_cast<float>(reading[0])));
  EXPECT_NE(style.file("map.tif").bytes.find("label=\"6.93 mm\""), std::string::npos);
}

TEST(RainfallStyle, of_no_readings_has_no_classes) {
  EXPECT_TRUE(
      RainfallStyle(RainfallClasses({}, {}), std::vector<double>{}, "mm").classes().empty());
}

TEST(RainfallStyle, takes_the_classes_and_colours_that_are_asked_for) {
  ClassRule rule = breaks_of({2, 5});
  rule.palette = Palette::greys;
  const std::vector<double> readings{0, 1, 2, 4, 9};
  const RainfallClasses classes(readings, rule);
  const RainfallStyle cells(classes, readings, "mm");
  ASSERT_EQ(cells.classes().size(), 4u) << "dry, below 2, 2 to 5, 5 and more";
  EXPECT_EQ(cells.classes()[2].low, 2);
  const std::string surface =
      RainfallStyle(classes, std::vector<double>{3}, "mm").file("map.tif").bytes;
  for (const char* label :
       {"label=\"dry\"", "label=\"below 2 mm\"", "label=\"2 to 5 mm\"", "label=\"from 5 mm\""})
    EXPECT_NE(surface.find(label), std::string::npos) << label;
  EXPECT_EQ(cells.file("map.tif").bytes, surface) << "so that it fits all rasters of a series";
  EXPECT_NE(surface.find("value=\"1.9999998807907104\""), std::string::npos)
      << "the float before 2, which itself is of the class above";
}

}  // namespace
}  // namespace thiessen::cli

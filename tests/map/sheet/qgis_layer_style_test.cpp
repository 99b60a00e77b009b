#include "map/sheet/qgis_layer_style.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

RainfallClasses classes(const std::vector<double>& readings, const std::vector<double>& breaks) {
  ClassRule rule;
  rule.kind = ClassRule::Kind::breaks;
  rule.breaks = breaks;
  return {readings, rule};
}

// A value that is a bound belongs to the upper class, and 0 to none of them.
TEST(QgisLayerStyle, classes_are_from_their_lower_bound_up_to_the_upper_one_and_0_is_dry) {
  const auto styled = styled_classes(classes({0, 5, 10, 25}, {10, 20}), "mm");
  ASSERT_EQ(styled.size(), 4U);
  EXPECT_EQ(styled[0].filter, "\"rainfall\" = 0");
  EXPECT_EQ(styled[0].label, "dry");
  EXPECT_EQ(styled[1].filter,
            "\"rainfall\" IS NOT NULL AND \"rainfall\" < 10 AND \"rainfall\" <> 0");
  EXPECT_EQ(styled[1].label, "below 10 mm");
  EXPECT_EQ(styled[2].filter,
            "\"rainfall\" IS NOT NULL AND \"rainfall\" >= 10 AND \"rainfall\" < 20 AND "
            "\"rainfall\" <> 0");
  EXPECT_EQ(styled[2].label, "10 to 20 mm");
  EXPECT_EQ(styled[3].filter,
            "\"rainfall\" IS NOT NULL AND \"rainfall\" >= 20 AND \"rainfall\" <> 0");
  EXPECT_EQ(styled[3].label, "from 20 mm");
}

TEST(QgisLayerStyle, has_the_colours_of_the_picture) {
  const RainfallClasses laid = classes({0, 5, 10, 25}, {10, 20});
  const auto styled = styled_classes(laid, "");
  EXPECT_EQ(styled[0].colour, laid.colour(0));
  EXPECT_EQ(styled[1].colour, laid.colour(5));
  EXPECT_EQ(styled[2].colour, laid.colour(10));
  EXPECT_EQ(styled[3].colour, laid.colour(25));
  EXPECT_EQ(styled[3].label, "from 20");
}

TEST(QgisLayerStyle, one_value_is_one_class_of_every_cell_that_has_one) {
  const auto styled = styled_classes(RainfallClasses({7, 7}, {}), "mm");
  ASSERT_EQ(styled.size(), 1U);
  EXPECT_EQ(styled[0].filter, "\"rainfall\" IS NOT NULL");
  EXPECT_EQ(styled[0].label, "rainfall");
}

TEST(QgisLayerStyle, a_class_is_a_rule_and_its_filter_is_text_in_xml) {
  const std::vector<StyledClass> styled{{"\"rainfall\" < 2", "below 2", {1, 2, 3}}};
  const std::string style = style_of_cells(styled);
  EXPECT_NE(style.find("type=\"RuleRenderer\""), std::string::npos);
  EXPECT_NE(style.find("filter=\"&quot;rainfall&quot; &lt; 2\" label=\"below 2\""),
            std::string::npos)
      << style;
  EXPECT_NE(style.find("<prop k=\"color\" v=\"1,2,3,255\"/>"), std::string::npos);
  EXPECT_NE(style.find("labelsEnabled=\"0\""), std::string::npos);
}

TEST(QgisLayerStyle, cells_without_rainfall_are_of_one_colour) {
  EXPECT_NE(style_of_cells({}).find("type=\"singleSymbol\""), std::string::npos);
}

TEST(QgisLayerStyle, gauges_basins_and_isohyets_are_named_by_their_field) {
  for (const auto& [style, field] :
       {std::pair{style_of_gauges(false), "station"}, std::pair{style_of_basins(), "basin"},
        std::pair{style_of_isohyets(), "rainfall"}}) {
    EXPECT_NE(style.find("labelsEnabled=\"1\""), std::string::npos);
    EXPECT_NE(style.find("fieldName=\"" + std::string(field) + "\""), std::string::npos);
    // Without a weight QGIS takes the thinnest face of a font.
    EXPECT_NE(style.find("fontWeight=\"50\""), std::string::npos);
  }
}

TEST(QgisLayerStyle, gauges_without_a_reading_are_hollow) {
  const std::string style = style_of_gauges(true);
  EXPECT_NE(style.find("symbol=\"1\" filter=\"&quot;rainfall&quot; IS NULL\""), std::string::npos);
  EXPECT_NE(style.find("<prop k=\"color\" v=\"255,255,255,255\"/>"), std::string::npos);
}

}  // namespace
}  // namespace thiessen

#include "map/sheet/qgis_style.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "map/sheet/palette.h"
#include "map/svg/xml_text.h"

namespace thiessen {
namespace {

// As QGIS 3.22 writes a style of unique values, and of discrete classes.
TEST(QgisStyle, values_have_a_palette) {
  const std::vector<StyleEntry> entries{{1, "A & B", {255, 0, 16}}, {12, "C", {0, 1, 2}}};
  const std::string style = style_of_values(entries);
  EXPECT_NE(style.find("<rasterrenderer type=\"paletted\" band=\"1\""), std::string::npos);
  EXPECT_NE(style.find("<paletteEntry value=\"1\" label=\"A &amp; B\" color=\"#ff0010\"/>\n"
                       "<paletteEntry value=\"12\""),
            std::string::npos);
}

TEST(QgisStyle, classes_reach_up_to_their_values_and_the_last_has_no_end) {
  const std::vector<StyleEntry> entries{{0.5, "0 to 0.5", {255, 255, 255}},
                                        {20, "1 to 20", {0, 0, 0}}};
  const std::string style = style_of_classes(entries);
  EXPECT_NE(style.find("type=\"singlebandpseudocolor\""), std::string::npos);
  EXPECT_NE(style.find("colorRampType=\"DISCRETE\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"0.5\" label=\"0 to 0.5\" color=\"#ffffff\"/>\n"
                       "<item value=\"inf\" label=\"1 to 20\" color=\"#000000\"/>"),
            std::string::npos);
}

// Colours as QGIS finds them: between the items on both sides of a value, by a straight line.
TEST(QgisStyle, numbers_run_from_colour_to_colour) {
  const auto colours = categorical_colours();
  const std::string style = style_of_numbers(7, 3);
  EXPECT_NE(style.find("colorRampType=\"INTERPOLATED\""), std::string::npos);
  const std::string items = "<item value=\"1\" color=\"" + hexadecimal(colours[0]) +
                            "\"/>\n<item value=\"4\" color=\"" + hexadecimal(colours[1]) +
                            "\"/>\n<item value=\"7\" color=\"" + hexadecimal(colours[2]) +
                            "\"/>\n<item value=\"10\"";
  EXPECT_NE(style.find(items), std::string::npos);
  EXPECT_LT(style_of_numbers(100'000, 3).size(), 1'400'000U);
}

TEST(QgisStyle, of_nothing_is_a_style_still) {
  EXPECT_TRUE(style_of_values({}).ends_with("</qgis>\n"));
  EXPECT_TRUE(style_of_classes({}).ends_with("</qgis>\n"));
}

}  // namespace
}  // namespace thiessen

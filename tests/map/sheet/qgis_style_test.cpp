#include "map/sheet/qgis_style.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace thiessen {
namespace {

// As QGIS 3.22 writes a style of unique values, and of discrete classes.
TEST(QgisStyle, values_have_a_palette) {
  const std::vector<StyleEntry> entries{{1, "A & B", {255, 0, 16}}, {12, "C", {0, 1, 2}}};
  const std::string style = style_of_values(entries);
  EXPECT_NE(style.find("<rasterrenderer type=\"paletted\" band=\"1\""), std::string::npos);
  EXPECT_NE(style.find("<paletteEntry value=\"1\" label=\"A &amp; B\" color=\"#ff0010\" "
                       "alpha=\"255\"/>\n<paletteEntry value=\"12\""),
            std::string::npos);
}

TEST(QgisStyle, classes_reach_up_to_their_values_and_the_last_has_no_end) {
  const std::vector<StyleEntry> entries{{0.5, "0 to 0.5", {255, 255, 255}},
                                        {20, "1 to 20", {0, 0, 0}}};
  const std::string style = style_of_classes(entries);
  EXPECT_NE(style.find("type=\"singlebandpseudocolor\""), std::string::npos);
  EXPECT_NE(style.find("colorRampType=\"DISCRETE\""), std::string::npos);
  EXPECT_NE(style.find("<item value=\"0.5\" label=\"0 to 0.5\" color=\"#ffffff\" alpha=\"255\"/>\n"
                       "<item value=\"inf\" label=\"1 to 20\" color=\"#000000\" alpha=\"255\"/>"),
            std::string::npos);
}

TEST(QgisStyle, of_nothing_is_a_style_still) {
  EXPECT_TRUE(style_of_values({}).ends_with("</qgis>\n"));
  EXPECT_TRUE(style_of_classes({}).ends_with("</qgis>\n"));
}

}  // namespace
}  // namespace thiessen

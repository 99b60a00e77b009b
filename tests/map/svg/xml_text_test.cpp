#include "map/svg/xml_text.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

TEST(XmlText, signs_of_xml_are_escaped_and_letters_stay) {
  EXPECT_EQ(xml_text("a<b>&\"c'"), "a&lt;b&gt;&amp;&quot;c'");
  EXPECT_EQ(xml_text("Łódź 東京 🌧"), "Łódź 東京 🌧");
}

TEST(XmlText, blanks_survive_an_attribute) {
  EXPECT_EQ(xml_text("a\tb\nc\rd"), "a&#9;b&#10;c&#13;d");
}

// XML 1.0, 2.2: controls, surrogates, FFFE and FFFF are no characters.
TEST(XmlText, what_xml_does_not_allow_is_replaced) {
  EXPECT_EQ(xml_text(std::string("a\0b\x01", 4)), "a\uFFFDb\uFFFD");
  EXPECT_EQ(xml_text("\uFFFE\uFFFF\uFFFD"), "\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(xml_text("\xFFz"), "\uFFFDz");
}

TEST(XmlText, a_colour_has_two_digits_a_channel) {
  EXPECT_EQ(hexadecimal({255, 0, 10}), "#ff000a");
}

}  // namespace
}  // namespace thiessen

#include "gdal/output/compact_xml.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(CompactXml, leaves_out_what_only_lays_it_out) {
  EXPECT_EQ(compact_xml("<?xml version=\"1.0\"?>\n<A>\n  <B a=\"x y\">t  u</B>\n  <C/>\n</A>\n"),
            "<?xml version=\"1.0\"?><A><B a=\"x y\">t  u</B><C/></A>");
}

TEST(CompactXml, keeps_what_an_element_holds_blanks_too) {
  EXPECT_EQ(compact_xml("<R>\n <F>  </F>\n <F>\n</F>\n <F> a </F>\n</R>"),
            "<R><F>  </F><F>\n</F><F> a </F></R>");
}

TEST(CompactXml, of_what_is_compact_or_no_xml_is_the_same) {
  for (const char* text : {"", "<A/>", "<A><B>1</B></A>", "a < b", "<", "text"})
    EXPECT_EQ(compact_xml(text), text);
}

}  // namespace
}  // namespace thiessen

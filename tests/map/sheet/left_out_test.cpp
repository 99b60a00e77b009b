// Linked with OpenCV: what is left out is told by pages, whose titles are set in type.
#include "map/sheet/left_out.h"

#include <gtest/gtest.h>

namespace thiessen {
namespace {

TEST(LeftOut, is_not_told_where_all_has_room) {
  Warnings warnings;
  LeftOut all(Page(), {.to_name = 3, .named = 3}, {});
  all.add("");
  all.tell(warnings);
  EXPECT_TRUE(warnings.notices().empty());
}

TEST(LeftOut, is_told_in_one_line) {
  Page page;
  page.title.resize(1);
  page.title[0].text.is_shortened = true;
  Warnings warnings;
  LeftOut some(page, {.to_name = 64, .named = 4, .isohyets = 9, .levelled = 7},
               {.has_cell_outlines = false});
  some.add_note("labelled: 3 of 9");
  some.tell(warnings);
  ASSERT_EQ(warnings.notices().size(), 1U);
  EXPECT_EQ(warnings.notices()[0].text.plain(),
            "the picture has no room for the end of the title, the names of 60 of 64 basins, the "
            "levels of 2 of 9 isohyets, the outlines of cells and the note \"labelled: 3 of 9\"");
}

TEST(LeftOut, tells_of_cells_without_an_outline_where_they_are_more_than_a_third) {
  const auto told = [](std::size_t outlined) {
    Warnings warnings;
    LeftOut(Page(), {.cells = 50, .outlined = outlined}, {}).tell(warnings);
    return warnings.notices().empty() ? "" : warnings.notices()[0].text.plain();
  };
  EXPECT_EQ(told(50), "");
  EXPECT_EQ(told(34), "");
  EXPECT_EQ(told(33), "the picture has no room for the outlines of 17 of 50 cells");
}

}  // namespace
}  // namespace thiessen

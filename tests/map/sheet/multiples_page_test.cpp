// Linked with OpenCV: a page has room for its texts.
#include "map/sheet/multiples_page.h"

#include <gtest/gtest.h>

#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

MultiplesPage laid_out(std::size_t maps, int width, int height) {
  Typesetter type;
  Picture picture = row_of_cells({1, 2, 3});
  picture.width = width;
  picture.height = height;
  const Legend legend(picture, classes_of(picture), page_style(width, height), type);
  return lay_out_multiples(picture, maps, {0, 0, 3, 2}, legend, type);
}

TEST(MultiplesPage, its_parts_stay_on_it_and_the_maps_between_title_and_footer) {
  for (const std::size_t maps : {2U, 3U, 5U, 12U, 30U}) {
    for (const auto& [width, height] : std::vector<std::pair<int, int>>{
             {1600, 0}, {1600, 1200}, {1200, 1700}, {3508, 2480}, {1000, 0}}) {
      const MultiplesPage sheet = laid_out(maps, width, height);
      const Page& page = sheet.page;
      EXPECT_EQ(page.width, width);
      EXPECT_TRUE(height == 0 || page.height == height);
      for (const PixelBox& box : sheet.maps) {
        EXPECT_GT(box.y, page.title.front().baseline);
        EXPECT_LE(box.bottom(), page.footer.y);
        EXPECT_LT(box.right(), page.legend.x);
        EXPECT_GE(box.height, 60);
      }
      EXPECT_LE(page.legend.right(), width);
      EXPECT_LE(page.footer.bottom(), page.height);
      EXPECT_LE(sheet.style.em, page.style.em);
    }
  }
}

TEST(MultiplesPage, without_room_is_an_error_that_names_the_page) {
  for (const auto& [maps, height] : std::vector<std::pair<std::size_t, int>>{{500, 400}, {2, 90}}) {
    try {
      laid_out(maps, 640, height);
      FAIL() << maps;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("maps have no room on a page of 640 x"),
                std::string::npos);
    }
  }
}

}  // namespace
}  // namespace thiessen

// Linked with OpenCV: a page has room for its texts.
#include "map/sheet/page.h"

#include <gtest/gtest.h>

#include <utility>

#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

bool overlap(const PixelBox& a, const PixelBox& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

TEST(Page, its_parts_do_not_overlap_and_stay_on_it) {
  Typesetter type;
  Picture picture = row_of_cells({1, 2, none});
  picture.title = std::string(300, 'W');
  picture.subtitle = "mean over 120 months";
  picture.units = "a very long unit that nobody would use for rainfall";
  for (const auto& [width, height] : std::vector<std::pair<int, int>>{
           {400, 0}, {400, 300}, {1600, 0}, {3000, 500}, {500, 3000}, {6000, 0}}) {
    picture.width = width;
    picture.height = height;
    const RainfallClasses classes = classes_of(picture);
    const Legend legend(picture, classes, page_style(width, height), type);
    const Page page = lay_out(picture, {0, 0, 3, 1}, legend, type);
    ASSERT_FALSE(page.style.bare);
    EXPECT_EQ(page.width, width);
    EXPECT_TRUE(height == 0 || page.height == height);
    for (const PixelBox& box : {page.panel, page.legend, page.footer}) {
      EXPECT_TRUE(box.x >= 0 && box.y >= 0 && box.right() <= page.width &&
                  box.bottom() <= page.height);
      EXPECT_GT(box.width, 0);
      EXPECT_GT(box.height, 0);
    }
    EXPECT_FALSE(overlap(page.panel, page.legend));
    EXPECT_FALSE(overlap(page.panel, page.footer));
    EXPECT_FALSE(overlap(page.legend, page.footer));
    ASSERT_TRUE(!page.title.empty() && page.title.size() <= 3);
    for (const TitleLine& line : page.title)
      EXPECT_LE(page.style.em + line.text.width(), page.width - page.style.em);
    EXPECT_LE(page.subtitle_baseline, page.panel.y);
    EXPECT_LE(page.title.back().baseline, page.subtitle_baseline - page.subtitle.baseline);
  }
}

TEST(Page, wraps_a_long_title_between_its_words) {
  Typesetter type;
  Picture picture = row_of_cells({1, 2});
  picture.width = 600;
  const RainfallClasses classes = classes_of(picture);
  const Legend legend(picture, classes, page_style(600, 0), type);
  const auto lines = [&](const std::string& title) {
    picture.title = title;
    std::vector<std::string> texts;
    int before = 0;
    for (const TitleLine& line : lay_out(picture, {0, 0, 2, 1}, legend, type).title) {
      texts.push_back(line.text.text);
      EXPECT_GE(line.baseline - line.text.baseline, before) << "below the line before";
      EXPECT_LE(line.text.width(), 600);
      before = line.baseline;
    }
    return texts;
  };
  EXPECT_EQ(lines("Rain").size(), 1u);
  std::string words;
  for (int i = 0; i < 14; ++i) words += i == 0 ? "rainfall" : " rainfall";
  const std::vector<std::string> two = lines(words);
  ASSERT_EQ(two.size(), 2u);
  EXPECT_EQ(two[0] + " " + two[1], words);
  const std::vector<std::string> three = lines(words + " " + words + " " + words);
  ASSERT_EQ(three.size(), 3u);
  EXPECT_EQ(three[0], two[0]);
  EXPECT_TRUE(three[2].ends_with("\u2026")) << three[2];
  // One word of 44 letters, some of two bytes, one with a mark that must not begin a line.
  const std::string word = "Niederschlagsmeßnetzbetreibergesellschaftsha\u0308user";
  const std::vector<std::string> parted = lines(word + word);
  ASSERT_EQ(parted.size(), 2u);
  EXPECT_EQ(parted[0] + parted[1], word + word);
  const std::vector<std::string> after_words = lines("Rain of the " + word + word);
  EXPECT_EQ(after_words.front(), "Rain of the");
  for (const std::string& line : lines("a\u0308" + std::string(300, 'W')))
    EXPECT_FALSE(line.starts_with("\u0308"));
}

TEST(Page, takes_the_shape_of_the_study_area_where_its_height_is_open) {
  Typesetter type;
  Picture picture;
  picture.width = 1000;
  const RainfallClasses classes = classes_of(picture);
  const Legend legend(picture, classes, page_style(1000, 0), type);
  const auto panel = [&](double width, double height) {
    return lay_out(picture, {0, 0, width, height}, legend, type).panel;
  };
  const PixelBox square = panel(1, 1);
  EXPECT_NEAR(square.height, square.width, 1);
  EXPECT_NEAR(panel(2, 1).height, square.width / 2.0, 1);
  EXPECT_EQ(panel(1, 100).height, panel(1, 1000).height) << "a page has an end";
  EXPECT_EQ(panel(100, 1).height, panel(1000, 1).height);
  EXPECT_EQ(panel(5, 0).height, panel(1000, 1).height);
}

TEST(Page, that_is_too_small_for_texts_is_the_map_alone) {
  Typesetter type;
  Picture picture = row_of_cells({1, 2});
  picture.width = 100;
  picture.height = 90;
  const RainfallClasses classes = classes_of(picture);
  const Legend legend(picture, classes, page_style(100, 90), type);
  const Page page = lay_out(picture, {0, 0, 2, 1}, legend, type);
  EXPECT_TRUE(page.style.bare);
  EXPECT_EQ(page.panel.width, 100);
  EXPECT_EQ(page.panel.height, 90);
  EXPECT_EQ(page.legend.width, 0);
  EXPECT_EQ(page.footer.height, 0);
}

TEST(PageStyle, law_1_letters_grow_with_the_picture_and_are_never_too_small_to_read) {
  int before = 0;
  for (int width = 64; width <= 20'000; width += 100) {
    const int em = page_style(width, 0).em;
    EXPECT_GE(em, before);
    EXPECT_GE(em, 11);
    EXPECT_EQ(page_style(width, width * 3 / 4).em, em) << "an open height counts as three quarters";
    before = em;
  }
  EXPECT_FALSE(page_style(1600, 0).bare);
  // A4 and A0 at 300 dots to the inch: ten points are 41.7 dots.
  EXPECT_EQ(page_style(3508, 2480, 300).em, 42);
  EXPECT_EQ(page_style(14'043, 9'933, 300).em, 42);
  // Four inches wide: nine points are 37.5 dots, though so small a picture's letters are 17 else.
  EXPECT_EQ(page_style(1200, 900, 300).em, 38);
  EXPECT_TRUE(page_style(200, 2000).bare);
  EXPECT_TRUE(page_style(2000, 150).bare);
}

TEST(PanelTransform, puts_the_extents_middle_into_the_panels_and_y_upward) {
  const PanelTransform transform({10, 20, 14, 22}, {5, 5, 400, 400});
  EXPECT_EQ(transform({12, 21}), (Point{200, 200})) << "in pixels of the panel";
  EXPECT_DOUBLE_EQ(transform.scale(), 400 * 0.92 / 4) << "a rim of 4 % on each side";
  EXPECT_LT(transform({12, 22}).y, 200);
  EXPECT_DOUBLE_EQ(transform({10, 21}).x, 400 * 0.04);
  EXPECT_DOUBLE_EQ(transform({14, 21}).x, 400 * 0.96);
}

// Names are 0.6 of an em: 9 points make them 5.4, at 300 dots to the inch 37.5 pixels.
TEST(Page, at_a_known_density_has_type_that_can_be_read_on_paper) {
  EXPECT_EQ(page_style(1181, 709, 300).em, 38);
  EXPECT_EQ(page_style(3508, 2480, 300).em, 42) << "10 points at most";
  EXPECT_FALSE(page_style(800, 600, 300).bare) << "but a heading has room";
}

// 100 by 60 mm. The legend wants more height than the map has beside a large title.
TEST(Page, has_a_smaller_title_where_the_legend_would_have_no_room) {
  Typesetter type;
  Picture picture = row_of_cells({1, 2, none});
  picture.width = 1181;
  picture.dots_to_the_inch = 300;
  picture.subtitle = "2020-01-02";
  picture.classes.kind = ClassRule::Kind::breaks;
  picture.classes.breaks = {1, 2, 3, 4};
  const auto laid_out = [&](int height) {
    picture.height = height;
    const RainfallClasses classes = classes_of(picture);
    const Legend legend(picture, classes, page_style(1181, height, 300), type);
    return lay_out(picture, {0, 0, 3, 2}, legend, type);
  };
  const Page low = laid_out(709);
  const Page high = laid_out(1181);
  EXPECT_LT(low.title.front().text.size, high.title.front().text.size);
  EXPECT_LT(low.panel.y, high.panel.y);
  EXPECT_EQ(low.legend.bottom(), low.footer.y);
  EXPECT_GE(low.subtitle.size, low.style.least_type);
}

// Five points are 20.8 dots at 300 to the inch.
TEST(PageStyle, has_no_type_below_five_points_where_the_density_is_known) {
  EXPECT_EQ(page_style(3508, 2480, 300).least_type, 21);
  EXPECT_EQ(page_style(3508, 2480, 0).least_type, 8);
  EXPECT_EQ(page_style(800, 600, 72).least_type, 8);
}

}  // namespace
}  // namespace thiessen

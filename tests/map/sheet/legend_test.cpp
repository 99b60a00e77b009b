// Linked with OpenCV: a legend is wide enough for its texts.
#include "map/sheet/legend.h"

#include <gtest/gtest.h>

#include "map/opencv/pixel_canvas.h"
#include "map/sheet/page.h"
#include "map/sheet/row_of_cells.h"
#include "map/svg/svg_canvas.h"

namespace thiessen {
namespace {

/// The legend of a picture that is large enough for texts.
struct Drawn {
  explicit Drawn(const Picture& shown) : picture(shown), classes(classes_of(shown)) {}

  Typesetter type;
  Picture picture;
  RainfallClasses classes;
  PageStyle style = {.em = 20};
  Legend legend{picture, classes, style, type};
};

TEST(Legend, has_a_line_for_each_sign_that_the_picture_has) {
  Picture picture = row_of_cells({1, 2});
  picture.by_rainfall = false;
  const int line = 20 * 3 / 2;
  EXPECT_EQ(Drawn(picture).legend.height(), 3 * line) << "gauge, cell, basin";
  picture.gauges[0].reports = false;
  EXPECT_EQ(Drawn(picture).legend.height(), 4 * line) << "and silent gauge";
  picture.gauges.clear();
  picture.basins.clear();
  EXPECT_EQ(Drawn(picture).legend.height(), line);
}

TEST(Legend, tells_of_cells_without_a_reading_where_there_are_any) {
  const int all_read = Drawn(row_of_cells({1, 2, 2})).legend.height();
  const int silent = Drawn(row_of_cells({1, 2, none})).legend.height();
  EXPECT_EQ(silent - all_read, 2 * 30) << "no reading, and the gauge that is silent";
}

TEST(Legend, of_a_surface_has_no_cells_and_of_isohyets_their_line) {
  Picture picture = row_of_cells({1, 2});
  const int cells = Drawn(picture).legend.height();
  picture.isohyets = {{"1.5", {}}};
  EXPECT_EQ(Drawn(picture).legend.height(), cells + 30);
  picture.bands = {{square(0, 0, 2), 1}};
  EXPECT_EQ(Drawn(picture).legend.height(), cells);
}

TEST(Legend, names_what_is_there) {
  const int wet = Drawn(row_of_cells({2, 4, 4})).legend.height();
  EXPECT_EQ(Drawn(row_of_cells({0, 2, 4})).legend.height() - wet, 30) << "a line for dry cells";
  Picture picture = row_of_cells({1, 2});
  picture.by_rainfall = false;
  const int of_basins = Drawn(picture).legend.width();
  picture.has_basins = false;
  EXPECT_GT(Drawn(picture).legend.width(), of_basins) << "study area in place of basin";
}

TEST(Legend, leaves_out_what_cannot_be_made_out) {
  Picture picture = row_of_cells({2});
  picture.by_rainfall = false;
  EXPECT_EQ(Drawn(picture).legend.height(), 2 * 30) << "gauge and basin: the cell is all of it";
  Typesetter type;
  const Legend whole_earth({&picture, 1}, {.has_basin_edges = false}, classes_of(picture),
                           {.em = 20}, type);
  EXPECT_EQ(whole_earth.height(), 30) << "the gauge";
}

TEST(Legend, of_several_maps_has_what_any_of_them_shows) {
  const std::vector<Picture> maps = {row_of_cells({1, 2}), row_of_cells({0, none})};
  Typesetter type;
  const PageStyle style = {.em = 20};
  const auto height = [&](std::span<const Picture> some, bool has_gauges) {
    return Legend(some, {.has_gauges = has_gauges}, classes_of(maps), style, type).height();
  };
  const int first = height({maps.data(), 1}, true);
  EXPECT_EQ(height(maps, true) - first, 3 * 30) << "dry, no reading, and the silent gauge";
  EXPECT_EQ(height(maps, true) - height(maps, false), 2 * 30) << "gauges that are not drawn";
}

TEST(Legend, of_a_bare_page_or_of_nothing_takes_no_width) {
  EXPECT_EQ(Drawn(Picture()).legend.width(), 0);
  const Picture picture = row_of_cells({1, 2});
  Typesetter type;
  EXPECT_EQ(Legend(picture, classes_of(picture), {.em = 20, .bare = true}, type).width(), 0);
}

TEST(Legend, is_drawn_within_its_column) {
  const Drawn drawn(row_of_cells({1, 20, none}));
  Page page;
  page.style = drawn.style;
  page.legend = {30, 40, drawn.legend.width(), 500};
  PixelCanvas canvas(30 + page.legend.width + 30, 600);
  drawn.legend.draw(canvas, page, drawn.classes);
  std::size_t inked = 0;
  for (int y = 0; y < 600; ++y) {
    for (int x = 0; x < canvas.width(); ++x) {
      const auto first = 3 * static_cast<std::size_t>(y * canvas.width() + x);
      const auto* pixel = &canvas.bytes()[first];
      if (pixel[0] == 255 && pixel[1] == 255 && pixel[2] == 255) continue;
      ++inked;
      EXPECT_TRUE(x >= 30 && x < page.legend.right() && y >= 40 && y < page.legend.bottom())
          << x << ' ' << y;
    }
  }
  EXPECT_GT(inked, 1000u);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// What a legend of five classes shows and leaves out in a column of this height.
struct InColumn {
  explicit InColumn(int height) {
    Picture picture = row_of_cells({1, 2, none});
    picture.classes.kind = ClassRule::Kind::breaks;
    picture.classes.breaks = {11, 22, 33, 44};
    const Drawn drawn(picture);
    Page page;
    page.style = drawn.style;
    page.legend = {30, 40, drawn.legend.width(), height};
    SvgCanvas canvas(300, 800);
    drawn.legend.draw(canvas, page, drawn.classes);
    svg = canvas.document("", "", {});
    left_out = drawn.legend.left_out(page);
    wanted = drawn.legend.height();
    least = drawn.legend.least_height();
  }
  /// How many bounds of classes, of 0, 11, 22, 33 and 44, have their text.
  std::size_t bounds() const {
    std::size_t count = 0;
    for (const char* bound : {">0</text>", ">11</text>", ">22</text>", ">33</text>", ">44</text>"})
      count += count_of(svg, bound);
    return count;
  }
  std::size_t signs() const {
    std::size_t count = 0;
    for (const char* sign : {"no reading", "rain gauge", "silent gauge", "cell", "basin"})
      count += count_of(svg, std::string(">") + sign + "</text>");
    return count;
  }

  std::string svg;
  std::string left_out;
  int wanted = 0;
  int least = 0;
};

TEST(Legend, has_all_of_it_in_its_least_height_and_nothing_to_say) {
  const InColumn first(500);
  EXPECT_LT(first.least, first.wanted);
  for (const int height : {first.least, (first.least + first.wanted) / 2, first.wanted, 500}) {
    const InColumn column(height);
    EXPECT_EQ(column.bounds(), 5U) << height;
    EXPECT_EQ(column.signs(), 5U) << height;
    EXPECT_EQ(column.left_out, "") << height;
  }
}

TEST(Legend, gives_up_signs_before_bounds_of_classes_and_tells_of_both) {
  const InColumn lower(InColumn(500).least - 60);
  EXPECT_EQ(lower.bounds(), 5U);
  EXPECT_EQ(lower.signs(), 2U) << "60 less than five lines of 23 have room for two";
  EXPECT_EQ(lower.left_out, "3 of the legend's 5 signs");
  const InColumn low(120);
  EXPECT_EQ(low.signs(), 0U);
  EXPECT_EQ(low.bounds(), 5U) << "in small type";
  EXPECT_EQ(low.left_out, "5 of the legend's 5 signs");
  const InColumn lowest(110);
  EXPECT_EQ(lowest.signs(), 0U);
  EXPECT_EQ(lowest.bounds(), 3U) << "0, 22 and 44";
  EXPECT_EQ(lowest.left_out, "2 of the legend's 5 bounds of classes, 5 of the legend's 5 signs");
}

TEST(Legend, has_no_sign_in_a_column_in_which_a_bound_of_classes_has_no_text) {
  for (int height = 60; height < 400; height += 3) {
    const InColumn column(height);
    EXPECT_TRUE(column.signs() == 0 || column.bounds() == 5) << height;
  }
}

TEST(Hatching, is_of_stripes_that_leave_most_of_the_ground_free) {
  for (const int em : {11, 20, 60}) {
    EXPECT_GE(hatching(em).width, 1);
    EXPECT_GE(hatching(em).spacing, 4 * hatching(em).width);
  }
}

}  // namespace
}  // namespace thiessen

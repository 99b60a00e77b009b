// Linked with OpenCV: a legend is wide enough for its texts.
#include "map/sheet/legend.h"

#include <gtest/gtest.h>

#include "map/opencv/pixel_canvas.h"
#include "map/sheet/page.h"
#include "map/sheet/row_of_cells.h"

namespace thiessen {
namespace {

TEST(RainfallClasses, a_value_takes_the_class_that_begins_at_or_below_it) {
  const RainfallClasses classes(row_of_cells({0, 0.1, 0.2, 1, none}));  // steps of 0.2
  ASSERT_EQ(classes.count(), 5u);
  EXPECT_EQ(classes.colour(0), classes.colour(0.1));
  EXPECT_NE(classes.colour(0.1), classes.colour(0.2));
  EXPECT_EQ(classes.colour(1), classes.colour(0.9)) << "the largest value is in the last class";
}

TEST(RainfallClasses, equal_values_make_one_class_and_none_make_none) {
  EXPECT_EQ(RainfallClasses(row_of_cells({4, 4})).count(), 1u);
  EXPECT_EQ(RainfallClasses(row_of_cells({none})).count(), 0u);
}

TEST(RainfallClasses, law_1_hold_every_reading_and_grow_darker_with_it) {
  const RainfallClasses classes(row_of_cells({0.3, 12, 47.5}));
  EXPECT_LE(classes.ticks().front().value(), 0.3);
  EXPECT_GE(classes.ticks().back().value(), 47.5);
  EXPECT_LE(classes.count(), 9u);
  int before = 3 * 255;
  for (double rainfall = 0.3; rainfall <= 47.5; rainfall += 0.1) {
    const Colour colour = classes.colour(rainfall);
    const int light = colour.red + colour.green + colour.blue;
    EXPECT_LE(light, before) << rainfall;
    before = light;
  }
}

TEST(RainfallClasses, there_are_none_of_cells_by_station) {
  Picture picture = row_of_cells({1, 2});
  picture.by_rainfall = false;
  EXPECT_EQ(RainfallClasses(picture).count(), 0u);
}

/// The legend of a picture that is large enough for texts.
struct Drawn {
  explicit Drawn(const Picture& shown) : picture(shown), classes(shown) {}

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

TEST(Legend, of_a_bare_page_or_of_nothing_takes_no_width) {
  EXPECT_EQ(Drawn(Picture()).legend.width(), 0);
  const Picture picture = row_of_cells({1, 2});
  Typesetter type;
  EXPECT_EQ(Legend(picture, RainfallClasses(picture), {.em = 20, .bare = true}, type).width(), 0);
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

TEST(Hatching, is_of_stripes_that_leave_most_of_the_ground_free) {
  for (const int em : {11, 20, 60}) {
    EXPECT_GE(hatching(em).width, 1);
    EXPECT_GE(hatching(em).spacing, 4 * hatching(em).width);
  }
}

}  // namespace
}  // namespace thiessen

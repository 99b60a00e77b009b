// Linked with OpenCV: numbers are set in type.
#include "map/plot/number_labels.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

#include "map/opencv/pixel_canvas.h"

namespace thiessen {
namespace {

TEST(NumberLabels, do_not_overlap_and_leave_dots_clear) {
  const PixelBox panel{30, 20, 200, 150};
  PixelCanvas canvas(260, 190);
  Typesetter type;
  NumberLabels labels(canvas, panel, type, 16);
  const Point dot{130.5, 95.5};
  labels.keep_clear(dot, 4);
  int written = 0;
  for (std::uint64_t number = 1; number <= 40; ++number) {
    written += labels.write(number, dot, 4, {0, 0, 0}) ? 1 : 0;
  }
  EXPECT_GE(written, 4);
  EXPECT_LE(written, 8);
  for (int y = 92; y < 99; ++y) {
    for (int x = 127; x < 134; ++x) {
      EXPECT_EQ(canvas.bytes()[static_cast<std::size_t>(3 * (y * 260 + x))], 255) << x << " " << y;
    }
  }
}

TEST(NumberLabels, stand_where_the_fewest_lines_are) {
  const PixelBox panel{0, 0, 200, 200};
  PixelCanvas canvas(200, 200);
  canvas.fill({100, 0, 100, 200}, {0, 0, 200});
  canvas.fill({0, 0, 200, 95}, {0, 0, 200});
  Typesetter type;
  NumberLabels labels(canvas, panel, type, 16);
  ASSERT_TRUE(labels.write(8, {100, 100}, 3, {0, 0, 0}));
  bool is_left_below = false;
  for (int y = 100; y < 140; ++y) {
    for (int x = 60; x < 98; ++x) {
      is_left_below =
          is_left_below || canvas.bytes()[static_cast<std::size_t>(3 * (y * 200 + x))] < 50;
    }
  }
  EXPECT_TRUE(is_left_below);
}

}  // namespace
}  // namespace thiessen

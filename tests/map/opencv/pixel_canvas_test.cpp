#include "map/opencv/pixel_canvas.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/core.hpp>
#include <vector>

namespace thiessen {
namespace {

constexpr Colour red{200, 10, 20};
constexpr Colour white{255, 255, 255};

Colour colour_at(PixelCanvas& canvas, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * canvas.width() + x));
  return {canvas.bytes()[first + 2], canvas.bytes()[first + 1], canvas.bytes()[first]};
}

/// How many pixels are not white.
std::size_t count_drawn(PixelCanvas& canvas) {
  std::size_t count = 0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) count += colour_at(canvas, x, y) == white ? 0u : 1u;
  }
  return count;
}

TEST(PixelCanvas, law_1_is_white_and_changes_where_it_is_drawn_on_alone) {
  PixelCanvas canvas(4, 3);
  EXPECT_EQ(canvas.bytes(), std::vector<std::uint8_t>(36, 255));
  canvas.fill({2, 1, 1, 1}, red);
  EXPECT_EQ(colour_at(canvas, 2, 1), red);
  EXPECT_EQ(count_drawn(canvas), 1u);
  const std::size_t first = 3 * (1 * 4 + 2);
  EXPECT_EQ(canvas.bytes()[first], red.blue);  // as encoders take them
  EXPECT_EQ(canvas.bytes()[first + 2], red.red);
  EXPECT_EQ(canvas.darkness({0, 0, 4, 3}), 3u * 255 - 200 - 10 - 20);
}

TEST(PixelCanvas, law_2_what_is_drawn_outside_changes_nothing) {
  PixelCanvas canvas(4, 3);
  const Window everywhere{{-100, -100, 300, 300}, {0, 0}};
  const Ring outside{{10, 10}, {20, 10}, {20, 20}};
  const Area area{{{&outside, 1}}, red, true, {}};
  const Polyline line(outside);
  canvas.fill({4, 0, 10, 10}, red);
  canvas.fill({-5, -5, 5, 100}, red);
  canvas.disc({-3, -3}, 2, red, {-10, -10, 100, 100});
  canvas.areas({&area, 1}, {}, everywhere);
  canvas.lines({&line, 1}, {red, 3}, everywhere);
  SetText text;
  text.ink = Coverage(3, 3);
  text.ink.at(1, 1) = 255;
  for (const int x : {-9, 4, 9}) canvas.text(text, x, 0, {red, 2, {}});
  EXPECT_EQ(count_drawn(canvas), 0u);
  canvas.fill({-5, 1, 100, 1}, red);
  EXPECT_EQ(count_drawn(canvas), 4u);
}

TEST(PixelCanvas, law_3_text_weighs_each_pixel_by_its_ink_and_is_cut_at_the_border) {
  SetText text;
  text.ink = Coverage(2, 2);
  text.ink.at(0, 0) = 255;
  text.ink.at(1, 0) = 0;
  text.ink.at(0, 1) = 51;  // a fifth
  text.ink.at(1, 1) = 255;
  PixelCanvas canvas(3, 3);
  canvas.text(text, 1, 1, {{0, 0, 0}, 0, {}});
  EXPECT_EQ(colour_at(canvas, 1, 1), (Colour{0, 0, 0}));
  EXPECT_EQ(colour_at(canvas, 2, 1), white);
  EXPECT_EQ(colour_at(canvas, 1, 2), (Colour{204, 204, 204}));
  EXPECT_EQ(count_drawn(canvas), 3u);
  PixelCanvas corner(3, 3);
  corner.text(text, 2, 2, {{0, 0, 0}, 0, {}});
  EXPECT_EQ(colour_at(corner, 2, 2), (Colour{0, 0, 0}));
  EXPECT_EQ(count_drawn(corner), 1u);
}

TEST(PixelCanvas, law_4_a_text_s_halo_is_white_around_it) {
  SetText text;
  text.ink = Coverage(1, 1);
  text.ink.at(0, 0) = 255;
  PixelCanvas canvas(11, 11);
  canvas.fill({0, 0, 11, 11}, {0, 0, 0});
  canvas.text(text, 5, 5, {red, 2, {}});
  EXPECT_EQ(colour_at(canvas, 5, 5), red);
  EXPECT_GT(colour_at(canvas, 7, 5).green, 200);
  EXPECT_EQ(colour_at(canvas, 8, 5), (Colour{0, 0, 0}));
}

TEST(PixelCanvas, law_5_a_border_lies_inside_its_box) {
  PixelCanvas canvas(20, 20);
  canvas.border({3, 4, 10, 8}, red, 2);
  EXPECT_EQ(count_drawn(canvas), 10u * 8 - 6 * 4);
  EXPECT_EQ(colour_at(canvas, 3, 4), red);
  EXPECT_EQ(colour_at(canvas, 12, 11), red);
  EXPECT_EQ(colour_at(canvas, 5, 6), white);
  EXPECT_EQ(colour_at(canvas, 2, 4), white);
  EXPECT_EQ(colour_at(canvas, 13, 11), white);
}

// In black on white the darkness of all pixels is the area of a disc whose rim fades over a pixel.
TEST(PixelCanvas, law_6_a_disc_is_as_dark_as_it_is_large_and_the_same_on_all_sides) {
  for (const double radius : {2.5, 4.0, 10.25}) {
    PixelCanvas canvas(40, 40);
    canvas.disc({20, 20}, radius, {0, 0, 0}, {0, 0, 40, 40});
    double dark = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        const Colour colour = colour_at(canvas, x, y);
        dark += (255 - colour.red) / 255.0;
        ASSERT_NEAR(colour.red, colour_at(canvas, 39 - x, y).red, 12);
        ASSERT_NEAR(colour.red, colour_at(canvas, y, x).red, 12);
      }
    }
    EXPECT_NEAR(dark / (M_PI * (radius * radius + 1. / 12)), 1, 0.03) << radius;
  }
}

TEST(PixelCanvas, law_7_a_disc_ends_at_its_clip) {
  PixelCanvas canvas(40, 40);
  canvas.disc({20, 20}, 10, red, {15, 12, 5, 30});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool is_inside = x >= 15 && x < 20 && y >= 12;
      EXPECT_TRUE(is_inside || colour_at(canvas, x, y) == white);
    }
  }
  EXPECT_EQ(colour_at(canvas, 19, 20), red);
}

/// Darkness of the whole picture in black pixels.
double black_pixels(PixelCanvas& canvas) {
  return static_cast<double>(canvas.darkness({0, 0, canvas.width(), canvas.height()})) / 765;
}

constexpr Colour black{0, 0, 0};
constexpr Window page{{0, 0, 200, 200}, {0, 0}};

TEST(PixelCanvas, law_8_a_line_covers_its_length_times_its_width_and_has_round_ends) {
  for (const double width : {0.375, 1.0, 1.25, 2.5, 6.0}) {
    for (int degrees = 0; degrees < 180; degrees += 13) {
      PixelCanvas canvas(200, 200);
      const double angle = degrees * M_PI / 180;
      const double dx = 80 * std::cos(angle);
      const double dy = 80 * std::sin(angle);
      const std::array<Point, 2> ends{Point{100 - dx, 100 - dy}, Point{100 + dx, 100 + dy}};
      const Polyline line(ends);
      canvas.lines({&line, 1}, {black, width}, page);
      const double exact = 160 * width + M_PI * width * width / 4;
      const double quantum = width < 4 ? 0.25 : 0.4;
      EXPECT_NEAR(black_pixels(canvas), exact, 160 * quantum + 2)
          << degrees << " degrees " << width;
    }
  }
}

TEST(PixelCanvas, law_9_lines_that_overlap_are_no_darker_than_one) {
  const std::array<Point, 2> ends{Point{3, 4}, Point{45, 31}};
  const std::vector<Polyline> twice{Polyline(ends), Polyline(ends)};
  PixelCanvas first(50, 50);
  PixelCanvas second(50, 50);
  first.lines({twice.data(), 1}, {black, 4, 100}, page);
  second.lines(twice, {black, 4, 100}, page);
  EXPECT_EQ(first.bytes(), second.bytes());
  EXPECT_EQ(colour_at(first, 24, 17).red, 155) << "100 / 255 of the way to black";
}

TEST(PixelCanvas, law_10_a_dashed_line_has_as_much_ink_as_its_dashes) {
  const std::array<Point, 2> ends{Point{20, 50}, Point{174, 50}};  // 5 dashes and 4 gaps
  const Polyline line(ends);
  PixelCanvas canvas(200, 200);
  canvas.lines({&line, 1}, {black, 3, 255, 22, 11}, page);
  EXPECT_NEAR(black_pixels(canvas), 5 * (22 * 3 + M_PI * 9 / 4), 5 * 22 * 0.25 + 5);
  EXPECT_EQ(colour_at(canvas, 30, 50), black);
  EXPECT_EQ(colour_at(canvas, 47, 50), white);
}

TEST(PixelCanvas, law_11_a_hole_stays_as_it_was_and_a_window_moves_and_cuts) {
  const std::vector<Ring> rings{{{0, 0}, {60, 0}, {60, 60}, {0, 60}},
                                {{20, 20}, {40, 20}, {40, 40}, {20, 40}}};
  const Area area{{rings}, red, false, {}};
  PixelCanvas canvas(200, 200);
  canvas.areas({&area, 1}, {}, {{100, 100, 50, 100}, {100, 100}});
  EXPECT_EQ(colour_at(canvas, 110, 110), red);
  EXPECT_EQ(colour_at(canvas, 130, 130), white);
  EXPECT_EQ(colour_at(canvas, 149, 159), red);
  EXPECT_EQ(colour_at(canvas, 150, 150), white) << "beyond the window";
  EXPECT_EQ(colour_at(canvas, 99, 110), white);
}

TEST(PixelCanvas, law_12_does_not_depend_on_the_number_of_opencv_s_threads) {
  const auto drawn = [](int threads) {
    const int before = cv::getNumThreads();
    cv::setNumThreads(threads);
    PixelCanvas canvas(900, 700);
    const Window whole{{0, 0, 900, 700}, {0, 0}};
    const Ring blob{{33.3, 20}, {870, 111.7}, {640, 680.4}, {90, 512.2}};
    const Area area{{{&blob, 1}}, red, true, {}};
    canvas.areas({&area, 1}, {black, 7, 2}, whole);
    const Polyline line(blob);
    canvas.lines({&line, 1}, {black, 2.6, 130, 12, 7}, whole);
    canvas.disc({450.3, 333.1}, 100.7, {10, 200, 40}, {0, 0, 900, 700});
    cv::setNumThreads(before);
    return canvas.bytes();
  };
  const auto one = drawn(1);
  EXPECT_EQ(drawn(2), one);
  EXPECT_EQ(drawn(7), one);
}

}  // namespace
}  // namespace thiessen

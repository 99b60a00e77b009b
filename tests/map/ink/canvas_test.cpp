#include "map/ink/canvas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace thiessen {
namespace {

constexpr Colour red{200, 10, 20};
constexpr Colour white{255, 255, 255};

Colour colour_at(Canvas& canvas, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * canvas.width() + x));
  return {canvas.bytes()[first + 2], canvas.bytes()[first + 1], canvas.bytes()[first]};
}

/// How many pixels are not white.
std::size_t count_drawn(Canvas& canvas) {
  std::size_t count = 0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (int x = 0; x < canvas.width(); ++x) count += colour_at(canvas, x, y) == white ? 0u : 1u;
  }
  return count;
}

TEST(Canvas, law_1_is_white_and_changes_where_it_is_drawn_on_alone) {
  Canvas canvas(4, 3);
  EXPECT_EQ(canvas.bytes(), std::vector<std::uint8_t>(36, 255));
  canvas.set(2, 1, red);
  EXPECT_EQ(colour_at(canvas, 2, 1), red);
  EXPECT_EQ(count_drawn(canvas), 1u);
  const std::size_t first = 3 * (1 * 4 + 2);
  EXPECT_EQ(canvas.bytes()[first], red.blue);  // as encoders take them
  EXPECT_EQ(canvas.bytes()[first + 2], red.red);
}

TEST(Canvas, law_2_what_is_drawn_outside_changes_nothing) {
  Canvas canvas(4, 3);
  const std::vector<std::pair<int, int>> outside{{-1, 0}, {0, -1}, {4, 0}, {0, 3}, {100, 100}};
  for (const auto& [x, y] : outside) canvas.set(x, y, red);
  canvas.fill({4, 0, 10, 10}, red);
  canvas.fill({-5, -5, 5, 100}, red);
  canvas.disc({-3, -3}, 2, red, {-10, -10, 100, 100});
  EXPECT_EQ(count_drawn(canvas), 0u);
  canvas.fill({-5, 1, 100, 1}, red);
  EXPECT_EQ(count_drawn(canvas), 4u);
}

// A sum of weights 255 never lies in the middle between two whole numbers.
TEST(Canvas, law_3_mixing_is_the_weighted_mean_to_the_nearest_whole_number) {
  for (int under = 0; under < 256; under += 15) {
    for (int alpha = 0; alpha < 256; ++alpha) {
      const auto level = static_cast<std::uint8_t>(under);
      Canvas canvas(1, 1);
      canvas.set(0, 0, {level, level, level});
      canvas.blend(0, 0, red, alpha);
      const auto mean = [&](int over) {
        return static_cast<std::uint8_t>(
            std::lround((under * (255 - alpha) + over * alpha) / 255.0));
      };
      ASSERT_EQ(colour_at(canvas, 0, 0), (Colour{mean(200), mean(10), mean(20)})) << alpha;
    }
  }
}

TEST(Canvas, law_4_coverage_weighs_each_pixel_and_is_cut_at_the_border) {
  Coverage coverage(2, 2);
  coverage.at(0, 0) = 255;
  coverage.at(1, 0) = 0;
  coverage.at(0, 1) = 51;  // a fifth
  coverage.at(1, 1) = 255;
  Canvas canvas(3, 3);
  canvas.blend(1, 1, coverage, {0, 0, 0});
  EXPECT_EQ(colour_at(canvas, 1, 1), (Colour{0, 0, 0}));
  EXPECT_EQ(colour_at(canvas, 2, 1), white);
  EXPECT_EQ(colour_at(canvas, 1, 2), (Colour{204, 204, 204}));
  EXPECT_EQ(count_drawn(canvas), 3u);
  Canvas half(3, 3);
  half.blend(2, 2, coverage, {0, 0, 0}, 51);
  EXPECT_EQ(colour_at(half, 2, 2), (Colour{204, 204, 204}));
  EXPECT_EQ(count_drawn(half), 1u);
}

TEST(Canvas, law_5_a_border_lies_inside_its_box) {
  Canvas canvas(20, 20);
  canvas.border({3, 4, 10, 8}, red, 2);
  EXPECT_EQ(count_drawn(canvas), 10u * 8 - 6 * 4);
  EXPECT_EQ(colour_at(canvas, 3, 4), red);
  EXPECT_EQ(colour_at(canvas, 12, 11), red);
  EXPECT_EQ(colour_at(canvas, 5, 6), white);
  EXPECT_EQ(colour_at(canvas, 2, 4), white);
  EXPECT_EQ(colour_at(canvas, 13, 11), white);
}

// In black on white the darkness of all pixels is the area of a disc whose rim fades over a pixel.
TEST(Canvas, law_6_a_disc_is_as_dark_as_it_is_large_and_the_same_on_all_sides) {
  for (const double radius : {2.5, 4.0, 10.25}) {
    Canvas canvas(40, 40);
    canvas.disc({20, 20}, radius, {0, 0, 0}, {0, 0, 40, 40});
    double dark = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        const Colour colour = colour_at(canvas, x, y);
        dark += (255 - colour.red) / 255.0;
        ASSERT_EQ(colour, colour_at(canvas, 39 - x, y));
        ASSERT_EQ(colour, colour_at(canvas, y, x));
      }
    }
    EXPECT_NEAR(dark / (M_PI * (radius * radius + 1. / 12)), 1, 0.03) << radius;
  }
}

TEST(Canvas, law_7_a_disc_ends_at_its_clip) {
  Canvas canvas(40, 40);
  canvas.disc({20, 20}, 10, red, {15, 12, 5, 30});
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      const bool is_inside = x >= 15 && x < 20 && y >= 12;
      EXPECT_TRUE(is_inside || colour_at(canvas, x, y) == white);
    }
  }
  EXPECT_EQ(colour_at(canvas, 19, 20), red);
}

}  // namespace
}  // namespace thiessen

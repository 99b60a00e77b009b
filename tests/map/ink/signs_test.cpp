#include "map/ink/signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "map/ink/ink.h"

namespace thiessen {
namespace {

constexpr PixelBox everywhere{0, 0, 41, 41};

Colour colour_at(Canvas& canvas, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * canvas.width() + x));
  return {canvas.bytes()[first + 2], canvas.bytes()[first + 1], canvas.bytes()[first]};
}

/// A gauge in the middle of a black page.
Canvas drawn(double radius, bool reports, const PixelBox& clip = everywhere) {
  Canvas canvas(41, 41);
  canvas.fill(everywhere, {0, 0, 0});
  draw_gauge(canvas, {20.5, 20.5}, radius, reports, clip);
  return canvas;
}

TEST(Signs, law_1_lines_are_a_pixel_wide_at_least_and_basins_stand_out) {
  double cell = 0;
  double basin = 0;
  for (int em = 1; em < 100; ++em) {
    EXPECT_GE(cell_line_width(em), std::max(1.0, cell));
    EXPECT_GE(basin_line_width(em), std::max(1.5, basin));
    EXPECT_GT(basin_line_width(em), 1.5 * cell_line_width(em));
    cell = cell_line_width(em);
    basin = basin_line_width(em);
  }
}

TEST(Signs, law_2_dots_shrink_where_they_crowd_down_to_what_can_be_seen) {
  double before = 1000;
  for (std::size_t gauges = 0; gauges < 100000; gauges = 2 * gauges + 1) {
    const double radius = gauge_radius(20, gauges, 1e6);
    EXPECT_LE(radius, before);
    EXPECT_LE(radius, 20 / 4);
    EXPECT_GE(radius, 1);
    // Dots and their rings on a lattice of as many pixels do not touch, unless they are smallest.
    if (gauges > 0 && radius > 1.5) {
      EXPECT_LT(2 * gauge_reach(radius), std::sqrt(1e6 / static_cast<double>(gauges)));
    }
    before = radius;
  }
  EXPECT_LT(before, 1.5);
  EXPECT_GT(gauge_radius(40, 5, 1e6), gauge_radius(20, 5, 1e6));
}

TEST(Signs, law_3_a_gauge_is_a_red_dot_in_a_white_ring_and_hollow_where_it_is_silent) {
  for (const double radius : {3.0, 6.0, 10.0}) {
    Canvas reporting = drawn(radius, true);
    Canvas silent = drawn(radius, false);
    EXPECT_EQ(colour_at(reporting, 20, 20), ink::gauge);
    EXPECT_EQ(colour_at(silent, 20, 20), ink::white);
    // Along the row to the right, by the distance of the pixels' middles.
    for (int x = 20; x < 41; ++x) {
      const double distance = x - 20;
      if (distance > 0.62 * radius + 0.5 && distance < radius - 0.5) {
        EXPECT_EQ(colour_at(reporting, x, 20), ink::gauge);
        EXPECT_EQ(colour_at(silent, x, 20), ink::gauge);
      }
      if (distance > radius + 0.5 && distance < gauge_reach(radius) - 0.5) {
        EXPECT_EQ(colour_at(reporting, x, 20), ink::white);
      }
      if (distance > gauge_reach(radius) + 0.5) {
        EXPECT_EQ(colour_at(reporting, x, 20), (Colour{0, 0, 0}));
        EXPECT_EQ(colour_at(silent, x, 20), (Colour{0, 0, 0}));
      }
    }
  }
}

TEST(Signs, law_4_the_ring_reaches_beyond_the_dot_and_grows_with_it) {
  double before = 0;
  for (double radius = 1; radius < 20; radius += 0.25) {
    EXPECT_GE(gauge_reach(radius), radius + 0.4);
    EXPECT_GT(gauge_reach(radius), before);
    before = gauge_reach(radius);
  }
}

TEST(Signs, law_5_nothing_is_drawn_beyond_the_clip) {
  Canvas canvas = drawn(8, false, {0, 0, 41, 20});
  for (int y = 20; y < 41; ++y) {
    for (int x = 0; x < 41; ++x) ASSERT_EQ(colour_at(canvas, x, y), (Colour{0, 0, 0}));
  }
  EXPECT_NE(colour_at(canvas, 20, 14), (Colour{0, 0, 0}));
}

}  // namespace
}  // namespace thiessen

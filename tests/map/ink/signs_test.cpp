#include "map/ink/signs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "map/ink/ink.h"
#include "map/ink/recording_canvas.h"

namespace thiessen {
namespace {

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
  const PixelBox clip{1, 2, 30, 40};
  for (const double radius : {3.0, 6.0, 10.0}) {
    RecordingCanvas reporting(41, 41);
    RecordingCanvas silent(41, 41);
    draw_gauge(reporting, {20.5, 19.5}, radius, true, clip);
    draw_gauge(silent, {20.5, 19.5}, radius, false, clip);
    ASSERT_EQ(reporting.discs.size(), 2u);
    ASSERT_EQ(silent.discs.size(), 3u);
    for (const RecordingCanvas* canvas : {&reporting, &silent}) {
      EXPECT_EQ(canvas->discs[0].colour, ink::white);
      EXPECT_EQ(canvas->discs[0].radius, gauge_reach(radius));
      EXPECT_EQ(canvas->discs[1].colour, ink::gauge);
      EXPECT_EQ(canvas->discs[1].radius, radius);
      for (const auto& disc : canvas->discs) {
        EXPECT_EQ(disc.centre, (Point{20.5, 19.5}));
        EXPECT_EQ(disc.clip.right(), clip.right()) << "nothing is drawn beyond the clip";
      }
    }
    EXPECT_EQ(silent.discs[2].colour, ink::white);
    EXPECT_LT(silent.discs[2].radius, radius - 0.5);
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

}  // namespace
}  // namespace thiessen

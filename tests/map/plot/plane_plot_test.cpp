// Linked with OpenCV: a plot's coordinates are set in type.
#include "map/plot/plane_plot.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

#include "map/opencv/pixel_canvas.h"
#include "map/plot/plot_sheet.h"

namespace thiessen {
namespace {

PlanePlot plot_of(const std::vector<Point>& points) {
  Tessellation<2> tessellation;
  tessellation.add_all(points);
  return PlanePlot(CoordinateRange<2>(tessellation));
}

TEST(PlanePlot, has_equal_scales_but_for_needles) {
  const PlanePlot plain = plot_of({{0, 0}, {20, 1}});
  EXPECT_EQ(plain.stretch(0), 1);
  EXPECT_EQ(plain.stretch(1), 1);
  const PlanePlot needle = plot_of({{0, 0}, {1e6, 1e-6}});
  EXPECT_EQ(needle.stretch(0), 1);
  EXPECT_NEAR(needle.stretch(1), 1e12 / 3, 1);
  const PlanePlot level = plot_of({{0, 3}, {1e6, 3}});
  EXPECT_EQ(level.stretch(1), 1);
}

TEST(PlanePlot, shows_every_point) {
  for (const auto& points : std::vector<std::vector<Point>>{
           {{4e6, 5e5}}, {{0, 0}, {0, 1e8}}, {{0, 0}, {1e6, 1e-6}, {2e5, 3e-7}}, {{-3, 1e-40}}}) {
    const PlanePlot plot = plot_of(points);
    const PixelBox panel = PlotSheet(plot.aspect(), PlotSheet::Margins::for_axes).panel();
    for (const Point p : points) {
      const Point pixel = plot.pixel(plot.scene()(p), panel);
      EXPECT_TRUE(pixel.x > panel.x + 20 && pixel.x < panel.right() - 20);
      EXPECT_TRUE(pixel.y > panel.y + 20 && pixel.y < panel.bottom() - 20);
    }
  }
}

// The longest side is 1 and there is a margin of 0.14 about it: (1 + 0.28) / (0.5 + 0.28).
TEST(PlanePlot, is_as_wide_as_the_points_are_but_never_higher_than_wide_nor_a_ribbon) {
  EXPECT_NEAR(plot_of({{0, 0}, {2, 1}}).aspect(), 1.28 / 0.78, 1e-12);
  EXPECT_NEAR(plot_of({{5, 5}, {5.1, 8}}).aspect(), 1, 1e-12);
  EXPECT_NEAR(plot_of({{0, 0}, {20, 1}}).aspect(), 2.4, 1e-12);
  EXPECT_NEAR(plot_of({{7, 7}}).aspect(), 1.5, 1e-12);
}

// In a panel of 1,280 pixels a unit of the scene, here two of the points', has 1,000.
TEST(PlanePlot, has_the_middle_of_the_points_in_the_middle_and_y_upward) {
  const PlanePlot plot = plot_of({{10, 20}, {12, 21}});
  const PixelBox panel{100, 50, 1280, 780};
  const Point middle = plot.pixel(plot.scene()({11, 20.5}), panel);
  EXPECT_NEAR(middle.x, 740, 1e-9);
  EXPECT_NEAR(middle.y, 440, 1e-9);
  const Point corner = plot.pixel(plot.scene()({12, 21}), panel);
  EXPECT_NEAR(corner.x, 1240, 1e-9);
  EXPECT_NEAR(corner.y, 190, 1e-9);
}

// Its corners are the panel's, whatever points there are.
TEST(PlanePlot, of_a_window_shows_it_and_no_more) {
  const PlanePlot plot = PlanePlot::of_window({{1e6, -5}, {1e6 + 30, 5}});
  EXPECT_NEAR(plot.aspect(), 3, 1e-12);
  const PixelBox panel{100, 50, 900, 300};
  const Point low = plot.pixel(plot.scene()({1e6, -5}), panel);
  EXPECT_NEAR(low.x, 100, 1e-6);
  EXPECT_NEAR(low.y, 350, 1e-6);
  const Point high = plot.pixel(plot.scene()({1e6 + 30, 5}), panel);
  EXPECT_NEAR(high.x, 1000, 1e-6);
  EXPECT_NEAR(high.y, 50, 1e-6);
  EXPECT_EQ(plot.stretch(0), 1);
  EXPECT_EQ(plot.stretch(1), 1);
  EXPECT_NEAR(PlanePlot::of_window({{0, 0}, {1, 100}}).stretch(0), 100.0 / 3, 1e-9);
}

// The range of 2 by 1 and its margins are 1.28 by 0.78 units of the scene.
TEST(PlanePlot, is_widened_and_never_narrowed) {
  PlanePlot wide = plot_of({{0, 0}, {2, 1}});
  wide.widen_to(4);
  EXPECT_NEAR(wide.half()[0], 4 * 0.39, 1e-12);
  EXPECT_NEAR(wide.half()[1], 0.39, 1e-12);
  PlanePlot tall = plot_of({{0, 0}, {2, 1}});
  tall.widen_to(0.5);
  EXPECT_NEAR(tall.half()[0], 0.64, 1e-12);
  EXPECT_NEAR(tall.half()[1], 1.28, 1e-12);
}

// Corners of the window and middles of its sides: the outer part of each dot stands on white.
TEST(PlanePlot, draws_points_on_the_edge_of_a_window_whole) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {8, 4}, {0, 4}, {4, 0}, {4, 4}, {0, 2}, {8, 2}};
  Tessellation<2> tessellation;
  tessellation.add_all(points);
  const PlaneWindow window{{0, 0}, {8, 4}};
  PixelCanvas canvas = plot_plane(
      tessellation, [](PointId) { return std::uint64_t{1}; }, window);
  const PlanePlot plot = PlanePlot::of_window(window);
  const PixelBox panel = PlotSheet(plot.aspect(), PlotSheet::Margins::for_axes).panel();
  for (const Point p : points) {
    const Point dot = plot.pixel(plot.scene()(p), panel);
    const int outward_x = p.x == 0 ? -1 : p.x == 8 ? 1 : 0;
    const int outward_y = p.y == 0 ? 1 : p.y == 4 ? -1 : 0;
    const auto x = static_cast<int>(dot.x) + 3 * outward_x;
    const auto y = static_cast<int>(dot.y) + 3 * outward_y;
    EXPECT_GT(canvas.darkness({x, y, 1, 1}), 3U * 150U) << p.x << ' ' << p.y;
  }
}

}  // namespace
}  // namespace thiessen

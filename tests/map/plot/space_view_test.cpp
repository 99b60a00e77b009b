// Linked with OpenCV: a view's numbers are set in type.
#include "map/plot/space_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "map/plot/plot_sheet.h"

namespace thiessen {
namespace {

/// The columns and rows in which there is ink of one colour, blue or red.
struct Spread {
  int left = 1 << 20;
  int right = -1;
  int top = 1 << 20;
  int bottom = -1;
};

Spread spread_of(PixelCanvas& canvas, const PixelBox& panel, bool is_blue) {
  constexpr int plainly = 60;
  Spread spread;
  for (int y = panel.y; y < panel.bottom(); ++y) {
    for (int x = panel.x; x < panel.right(); ++x) {
      const auto at = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.width()) +
                           static_cast<std::size_t>(x));
      const int more_blue = canvas.bytes()[at] - canvas.bytes()[at + 2];
      if ((is_blue ? more_blue : -more_blue) <= plainly) continue;
      spread.left = std::min(spread.left, x);
      spread.right = std::max(spread.right, x);
      spread.top = std::min(spread.top, y);
      spread.bottom = std::max(spread.bottom, y);
    }
  }
  return spread;
}

// One looks down the z axis at two points on the x axis: the Delaunay edge between them lies
// across, through the middle, and the wall half-way stands upright, as y points up.
TEST(SpaceView, from_above_has_x_to_the_right_and_y_upward) {
  Tessellation<3> tessellation;
  tessellation.add_all(std::vector<SpacePoint>{{-1, 0, 0}, {1, 0, 0}});
  for (const PlotSize& size : {PlotSize{}, PlotSize{900, 900}}) {
    PixelCanvas canvas = view_space(
        tessellation, [](PointId p) { return index(p); }, View{{0, 0, 10}, {0, 0, 0}}, size);
    constexpr auto plain = PlotSheet::Margins::plain;
    const double aspect = size.height > 0 ? PlotSheet::aspect_of_room(plain, size) : 1.35;
    const PixelBox panel = PlotSheet(aspect, plain, size).panel();
    const int middle_x = panel.x + panel.width / 2;
    const int middle_y = panel.y + panel.height / 2;
    const Spread delaunay = spread_of(canvas, panel, true);
    EXPECT_NEAR(delaunay.top, middle_y, 4);
    EXPECT_NEAR(delaunay.bottom, middle_y, 4);
    EXPECT_NEAR(delaunay.left + delaunay.right, 2 * middle_x, 4);
    EXPECT_GT(delaunay.right - delaunay.left, 200);
    const Spread wall = spread_of(canvas, panel, false);
    EXPECT_NEAR(wall.left, middle_x, 4);
    EXPECT_NEAR(wall.right, middle_x, 4);
    EXPECT_NEAR(wall.top + wall.bottom, 2 * middle_y, 4);
    EXPECT_GT(wall.bottom - wall.top, 100);
    EXPECT_EQ(canvas.width(), size.width);
  }
}

}  // namespace
}  // namespace thiessen

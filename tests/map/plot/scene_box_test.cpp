// Linked with OpenCV: a box's coordinates are set in type.
#include "map/plot/scene_box.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace thiessen {
namespace {

/// The unit cube in its box, seen from somewhere towards its middle.
struct SeenCube {
  explicit SeenCube(const SceneVector& from) : eye(from) {}

  static SceneCoordinates<3> cube() {
    CoordinateRange<3> range;
    range.low = {0, 0, 0};
    range.high = {1, 1, 1};
    return {range, {1, 1, 1}};
  }

  /// Whether anything but white is at these pixels.
  bool has_ink(int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const auto at = static_cast<std::size_t>(3 * (y * sheet.canvas().width() + x));
        if (sheet.canvas().bytes()[at] != 255) return true;
      }
    }
    return false;
  }

  SceneVector eye;
  SceneVector half{0.7, 0.7, 0.7};
  SceneCoordinates<3> scene = cube();
  PlotSheet sheet{1.35, PlotSheet::Margins::plain};
  Camera camera{eye, -1 * eye, half, sheet.panel(), Camera::Middle::straight_ahead};
  SceneBox box{scene, half, camera, eye};
};

// The middle of each is on the picture.
TEST(SceneBox, has_twelve_edges_in_its_corners) {
  SeenCube seen({3, -4, 2});
  DepthDrawing drawing(seen.camera, seen.sheet.panel());
  seen.box.add_edges(drawing, {{0, 0, 0}, 3, 0, 0, 0});
  drawing.draw(seen.sheet.canvas());
  int drawn = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      SceneVector middle{};
      middle[(axis + 1) % 3] = corner % 2 == 0 ? -0.7 : 0.7;
      middle[(axis + 2) % 3] = corner < 2 ? -0.7 : 0.7;
      const Point at = seen.camera.pixel(seen.camera.seen(middle));
      const int x = static_cast<int>(at.x);
      const int y = static_cast<int>(at.y);
      drawn += seen.has_ink(x - 1, y - 1, x + 2, y + 2) ? 1 : 0;
    }
  }
  EXPECT_EQ(drawn, 12);
}

}  // namespace
}  // namespace thiessen

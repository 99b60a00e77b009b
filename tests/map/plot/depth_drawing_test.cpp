// Linked with OpenCV: what is drawn is looked at in pixels.
#include "map/plot/depth_drawing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "map/opencv/pixel_canvas.h"

namespace thiessen {
namespace {

constexpr PixelBox panel{20, 10, 300, 200};
constexpr Colour red{200, 0, 0};
constexpr Colour blue{0, 0, 200};

/// Looks along y from (0, -3, 0), x to the right and z upward.
const Camera camera({0, -3, 0}, {0, 1, 0}, {1, 1, 1}, panel, Camera::Middle::straight_ahead);

Colour pixel(PixelCanvas& canvas, Point at) {
  const auto offset =
      3 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(canvas.width()) +
           static_cast<std::size_t>(at.x));
  const auto& bytes = canvas.bytes();
  return {bytes[offset + 2], bytes[offset + 1], bytes[offset]};
}

TEST(DepthDrawing, goes_from_the_farthest_to_the_nearest) {
  DepthDrawing drawing(camera, panel);
  drawing.add_line({-0.5, -1, 0}, {0.5, 1, 0.2}, {red, 3, 0, 0, 2});
  drawing.add_line({0.5, -1, 0}, {-0.5, 1, 0.3}, {blue, 3, 8, 5, 2});
  drawing.add_ball({0, 0.5, 0}, 0.05, 1, 100, red);
  const auto pieces = drawing.in_order();
  ASSERT_GT(pieces.size(), 5u);
  for (std::size_t i = 1; i < pieces.size(); ++i) EXPECT_LE(pieces[i].ahead, pieces[i - 1].ahead);
}

TEST(DepthDrawing, draws_what_is_near_over_what_is_far_in_whatever_order_they_come) {
  for (const bool near_first : {true, false}) {
    DepthDrawing drawing(camera, panel);
    const auto add = [&](bool near) {
      if (near) {
        drawing.add_line({-0.5, -0.5, 0}, {0.5, -0.5, 0}, {red, 5, 0, 0, 0});
      } else {
        drawing.add_line({0, 0.5, -0.5}, {0, 0.5, 0.5}, {blue, 5, 0, 0, 0});
      }
    };
    add(near_first);
    add(!near_first);
    PixelCanvas canvas(340, 220);
    drawing.draw(canvas);
    const Point crossing = camera.pixel(camera.seen({0, 0, 0}));
    const Colour at = pixel(canvas, crossing);
    EXPECT_GT(at.red, at.blue + 50);
  }
}

TEST(DepthDrawing, far_lines_are_fainter_and_thinner) {
  DepthDrawing drawing(camera, panel);
  drawing.add_line({-0.5, 0.6, 0}, {0.5, 0.6, 0}, {red, 4, 0, 0, 0});
  drawing.add_line({-0.3, -0.6, 0}, {0.3, -0.6, 0}, {red, 4, 0, 0, 0});
  const auto pieces = drawing.in_order();
  const auto& far = pieces.front();
  const auto& near = pieces.back();
  EXPECT_NEAR(far.ahead, 3.6, 1e-9);
  EXPECT_NEAR(near.ahead, 2.4, 1e-9);
  EXPECT_LT(far.width, near.width);
  EXPECT_GT(far.colour.green, near.colour.green + 20);
}

TEST(DepthDrawing, near_balls_are_larger) {
  DepthDrawing drawing(camera, panel);
  drawing.add_ball({0, 1, 0}, 0.05, 0.1, 100, red);
  drawing.add_ball({0, -1, 0}, 0.05, 0.1, 100, red);
  const auto pieces = drawing.in_order();
  EXPECT_NEAR(pieces[1].width / pieces[0].width, 2, 1e-9);  // 4 and 2 ahead
}

TEST(DepthDrawing, what_lies_behind_the_eye_is_cut_off) {
  DepthDrawing drawing(camera, panel);
  drawing.add_line({0, -9, 0.1}, {0.3, 1, 0}, {red, 3, 8, 5, 0});
  drawing.add_line({0, -9, 0}, {0, -5, 0}, {red, 3, 0, 0, 0});
  drawing.add_ball({0, -4, 0}, 0.05, 1, 100, red);
  const auto pieces = drawing.in_order();
  ASSERT_FALSE(pieces.empty());
  EXPECT_LT(pieces.size(), 100u);
  for (const auto& piece : pieces) {
    EXPECT_GE(piece.ahead, camera.near_plane());
    EXPECT_FALSE(piece.is_ball);
    for (const Point p : {piece.from, piece.to}) {
      EXPECT_TRUE(p.x >= 16 && p.x <= 324 && p.y >= 6 && p.y <= 214);
    }
  }
}

TEST(DepthDrawing, leaves_everything_outside_the_panel_white) {
  DepthDrawing drawing(camera, panel);
  drawing.add_line({-50, 1, -30}, {50, 1, 30}, {red, 30, 0, 0, 4});
  drawing.add_line({-50, 0, 30}, {50, 0, -30}, {blue, 9, 20, 10, 4});
  drawing.add_ball({camera.pixels_per_unit(3) > 0 ? 150 / camera.pixels_per_unit(3) : 0, 0, 0}, 1,
                   1, 40, red);
  PixelCanvas canvas(340, 220);
  drawing.draw(canvas);
  int inside = 0;
  for (int y = 0; y < 220; ++y) {
    for (int x = 0; x < 340; ++x) {
      if (pixel(canvas, {x * 1.0, y * 1.0}) == Colour{255, 255, 255}) continue;
      const bool in_panel = x >= 20 && x < 320 && y >= 10 && y < 210;
      EXPECT_TRUE(in_panel) << x << " " << y;
      ++inside;
    }
  }
  EXPECT_GT(inside, 1000);
}

}  // namespace
}  // namespace thiessen

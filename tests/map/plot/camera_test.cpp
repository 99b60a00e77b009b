#include "map/plot/camera.h"

#include <gtest/gtest.h>
#include <algorithm>

#include <vector>

namespace thiessen {
namespace {

constexpr PixelBox panel{100, 50, 800, 600};
constexpr SceneVector half{0.7, 0.6, 0.5};

TEST(Camera, sees_the_site_in_the_middle_and_z_upward) {
  const Camera camera({3, -4, 2}, {-2.9, 4.2, -1.9}, half, panel, Camera::Middle::straight_ahead);
  const Point site = camera.pixel(camera.seen({0.1, 0.2, 0.1}));
  EXPECT_NEAR(site.x, 500, 1e-9);
  EXPECT_NEAR(site.y, 350, 1e-9);
  const Point above = camera.pixel(camera.seen({0.1, 0.2, 0.3}));
  EXPECT_NEAR(above.x, 500, 1e-9);
  EXPECT_LT(above.y, site.y);
  EXPECT_NEAR(camera.seen({0.1, 0.2, 0.1})[2], std::sqrt(2.9 * 2.9 + 4.2 * 4.2 + 1.9 * 1.9), 1e-12);
}

TEST(Camera, looking_down_sees_y_upward_and_x_to_the_right) {
  const Camera camera({0, 0, 5}, {0, 0, -1}, half, panel, Camera::Middle::straight_ahead);
  const Point origin = camera.pixel(camera.seen({0, 0, 0}));
  EXPECT_LT(camera.pixel(camera.seen({0, 0.5, 0})).y, origin.y);
  EXPECT_GT(camera.pixel(camera.seen({0.5, 0, 0})).x, origin.x);
}

TEST(Camera, near_things_are_larger) {
  const Camera camera({0, -5, 0}, {0, 1, 0}, half, panel, Camera::Middle::straight_ahead);
  EXPECT_NEAR(camera.pixels_per_unit(4) / camera.pixels_per_unit(8), 2, 1e-12);
  const Point near = camera.pixel(camera.seen({0.5, -1, 0}));
  const Point far = camera.pixel(camera.seen({0.5, 1, 0}));
  EXPECT_GT(near.x, far.x);
}

TEST(Camera, has_the_box_in_the_panel_and_fills_most_of_it) {
  for (const SceneVector& eye : std::vector<SceneVector>{{2, -2, 1}, {0, 0, 9}, {1e4, 1e4, -3e3}}) {
    for (const auto middle : {Camera::Middle::straight_ahead, Camera::Middle::box}) {
      const Camera camera(eye, -1 * eye, half, panel, middle);
      ASSERT_TRUE(camera.is_outside());
      double left = 1e9;
      double right = -1e9;
      double top = 1e9;
      double bottom = -1e9;
      for (int i = 0; i < 8; ++i) {
        const Point p = camera.pixel(camera.seen(
            {(i & 1 ? 1 : -1) * half[0], (i & 2 ? 1 : -1) * half[1], (i & 4 ? 1 : -1) * half[2]}));
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
      }
      EXPECT_TRUE(left >= 100 && right <= 900 && top >= 50 && bottom <= 650);
      EXPECT_TRUE(right - left > 400 || bottom - top > 400);
      if (middle == Camera::Middle::box) {
        EXPECT_NEAR((left + right) / 2, 500, 1e-6);
        EXPECT_NEAR((top + bottom) / 2, 350, 1e-6);
      }
    }
  }
}

TEST(Camera, knows_whether_the_box_lies_ahead) {
  const Camera inside({0, 0, 0}, {1, 0, 0}, half, panel, Camera::Middle::straight_ahead);
  EXPECT_FALSE(inside.is_outside());
  EXPECT_TRUE(inside.sees_box());
  EXPECT_EQ(inside.nearest(), inside.near_plane());
  EXPECT_NEAR(inside.farthest(), 0.7, 1e-12);
  const Camera away({3, 0, 0}, {1, 0, 0}, half, panel, Camera::Middle::straight_ahead);
  EXPECT_FALSE(away.sees_box());
}

}  // namespace
}  // namespace thiessen

#include "rainfall/normals/pixel_areas.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "earth/area/earth_area.h"
#include "earth/area/ellipsoid_area.h"

namespace thiessen {
namespace {

// The whole Earth in pixels of one degree.
TEST(PixelsInDegrees, of_the_whole_earth_are_its_area) {
  const PixelsInDegrees pixels(90, -1, 1, 180);
  EXPECT_NEAR(360 * pixels.ordinate(180), earth_area, 1e-13 * earth_area);
  EXPECT_NEAR(pixels.ordinate(90), pixels.ordinate(180) / 2, 1e-13 * pixels.ordinate(180));
}

TEST(PixelsInDegrees, that_are_small_are_measured_by_parabolas) {
  const double height = 1.0 / 24;
  for (const double sign : {-1.0, 1.0}) {
    const PixelsInDegrees pixels(50, sign * height, height, 200);
    const double of_row = pixels.ordinate(1);
    for (const double row : {0.0, 0.3, 0.9, 1.0, 57.25, 199.99, 200.0}) {
      const double exact = height * std::abs(area_under({0, 50 + sign * row * height},
                                                        {1, 50 + sign * row * height}, 50));
      EXPECT_NEAR(pixels.ordinate(row), exact, 1e-8 * of_row);
    }
  }
}

// A scale that is linear in rows and columns is had exactly, at the middles of pixels.
TEST(PixelsOfPlane, have_linear_scales_exactly) {
  const std::size_t columns = 40;
  const std::size_t rows = 33;
  std::vector<double> nodes;
  for (std::size_t r = 0; r < PixelsOfPlane::nodes_along(rows, 16); ++r) {
    for (std::size_t c = 0; c < PixelsOfPlane::nodes_along(columns, 16); ++c)
      nodes.push_back(100 + 16.0 * static_cast<double>(r) + 32.0 * static_cast<double>(c));
  }
  const PixelsOfPlane pixels(nodes, columns, 16);
  EXPECT_DOUBLE_EQ(pixels.scale(0, 0), 100 + 0.5 + 1);
  EXPECT_DOUBLE_EQ(pixels.scale(32, 39), 100 + 32.5 + 2 * 39.5);
}

}  // namespace
}  // namespace thiessen

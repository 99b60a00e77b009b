#include "gdal/output/surface_bands.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace thiessen {
namespace {

// 10 x 10 pixels over (0, 0) to (10, 10), whose value is the x of their centres.
const PixelGrid grid{{0, 10}, 1, 10, 10};

std::vector<float> plane() {
  std::vector<float> values;
  for (int i = 0; i < 100; ++i) values.push_back(static_cast<float>(i % 10) + 0.5F);
  return values;
}

MultiPolygon box(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
}

double area(const MultiPolygon& shape) {
  const auto of = [](const Ring& ring) {
    double sum = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      sum += (a.x * b.y - b.x * a.y) / 2;
    }
    return std::abs(sum);
  };
  double sum = 0;
  for (const Polygon& part : shape) {
    sum += of(part.outer);
    for (const Ring& hole : part.holes) sum -= of(hole);
  }
  return sum;
}

// Between x = 1 and 9 the plane's levels 3.25 and 5.5 part 8 x 6 into 2.25, 2.25 and 3.5 times 6.
TEST(SurfaceBands, of_a_plane_part_the_area_at_the_levels) {
  const std::vector<float> values = plane();
  const auto bands = bands_of({grid, values}, std::array{3.25, 5.5, 40.0}, box(1, 2, 9, 8), 100);
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_NEAR(area(bands[0].shape), 2.25 * 6, 1e-4);
  EXPECT_NEAR(area(bands[1].shape), 2.25 * 6, 1e-4);
  EXPECT_NEAR(area(bands[2].shape), 3.5 * 6, 1e-4);
  EXPECT_EQ(bands[0].least, 0.5) << "what lies below the lowest level begins with the least value";
  EXPECT_EQ(bands[0].largest, 3.25);
  EXPECT_EQ(bands[2].least, 5.5);
}

TEST(SurfaceBands, without_a_level_among_the_values_are_the_area) {
  const std::vector<float> values = plane();
  const auto bands = bands_of({grid, values}, std::array{40.0}, box(1, 2, 9, 8), 0.5);
  ASSERT_EQ(bands.size(), 1U);
  EXPECT_NEAR(area(bands[0].shape), 48, 1e-9);
  EXPECT_GE(bands[0].shape[0].outer.size(), 56U) << "no edge is longer than 0.5";
  const std::vector<float> none(100, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(bands_of({grid, none}, std::array{1.0}, box(1, 2, 9, 8), 100).empty());
}

// The surface ends at x = 6.25, in the last band.
TEST(SurfaceBands, end_where_the_surface_does) {
  const std::vector<float> values = plane();
  std::vector<std::uint8_t> is_within;
  for (const float value : values) is_within.push_back(value <= 6.25 ? 1 : 0);
  const PixelValues surface{grid, values, is_within, [](Point p) { return p.x <= 6.25; }};
  const auto bands = bands_of(surface, std::array{3.25, 5.5}, box(1, 2, 9, 8), 100);
  ASSERT_EQ(bands.size(), 3U);
  EXPECT_NEAR(area(bands[1].shape), 2.25 * 6, 1e-4);
  EXPECT_NEAR(area(bands[2].shape), 0.75 * 6, 1e-4);
  const auto whole = bands_of(surface, std::array{40.0}, box(1, 2, 9, 8), 100);
  ASSERT_EQ(whole.size(), 1U);
  EXPECT_NEAR(area(whole[0].shape), 5.25 * 6, 1e-4);
}

TEST(SurfaceBands, of_shapes_that_touch_and_overlap_are_cut_to_their_union) {
  const std::array shapes = {box(1, 1, 4, 4), box(4, 1, 6, 4), box(5, 2, 7, 3)};
  const MultiPolygon whole = union_of(shapes);
  EXPECT_EQ(whole.size(), 1U);
  EXPECT_NEAR(area(whole), 9 + 6 + 1, 1e-12);
}

}  // namespace
}  // namespace thiessen

#include "map/raster/raster_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "geometry/ring_location.h"

namespace thiessen {
namespace {

MultiPolygon rectangle(double west, double south, double east, double north) {
  return {{{{west, south}, {east, south}, {east, north}, {west, north}}, {}}};
}

TEST(RasterGrid, snaps_outward_to_multiples_of_the_resolution) {
  const std::vector<MultiPolygon> areas{rectangle(-12.5, 7, 3, 20), rectangle(0, 1, 41, 5)};
  const PixelGrid grid = grid_over(areas, 10);
  EXPECT_EQ(grid.pixel, 10);
  EXPECT_EQ(grid.north_west, (Point{-20, 20}));
  EXPECT_EQ(grid.columns, 7);
  EXPECT_EQ(grid.rows, 2);
}

TEST(RasterGrid, multiples_stay_whatever_rounding_does) {
  // 0.3 / 0.1 and 4.35 / 0.01 are not whole numbers in doubles.
  const PixelGrid tenths = grid_over({rectangle(0.1, -0.3, 0.7, 0.3)}, 0.1);
  EXPECT_EQ(tenths.columns, 6);
  EXPECT_EQ(tenths.rows, 6);
  EXPECT_EQ(tenths.north_west.y, 0.1 * 3);
  const PixelGrid hundredths = grid_over({rectangle(4.35, 0, 5.35, 1)}, 0.01);
  EXPECT_EQ(hundredths.columns, 100);
  EXPECT_EQ(hundredths.rows, 100);
}

TEST(RasterGrid, without_a_resolution_the_longer_side_has_2000_pixels) {
  const PixelGrid grid = grid_over({rectangle(0, 0, 500, 1000)}, 0);
  EXPECT_EQ(grid.pixel, 0.5);
  EXPECT_EQ(grid.columns, 1000);
  EXPECT_EQ(grid.rows, 2000);
}

TEST(RasterGrid, covers_the_areas_in_one_pixel_at_least) {
  const PixelGrid grid = grid_over({rectangle(3, 3, 4, 4)}, 1e6);
  EXPECT_EQ(grid.columns, 1);
  EXPECT_EQ(grid.rows, 1);
  EXPECT_EQ(grid.north_west, (Point{0, 1e6}));
}

TEST(RasterGrid, refuses_too_many_pixels_and_no_extent) {
  const std::vector<MultiPolygon> square{rectangle(0, 0, 1, 1)};
  EXPECT_NO_THROW(grid_over(square, 1.0 / 20'000));
  EXPECT_THROW(grid_over(square, 1.0 / 20'001), Error);
  EXPECT_THROW(grid_over({rectangle(0, 0, 100'001, 2)}, 1), Error);
  EXPECT_THROW(grid_over(square, 1e-300), Error);
  EXPECT_THROW(grid_over({}, 1), Error);
}

TEST(RasterGrid, an_extent_s_edges_are_curves_in_the_raster) {
  // Polar coordinates: the extent is a ring of a quarter circle.
  const auto polar = [](std::vector<Point>& points) {
    for (Point& p : points) p = {p.y * std::cos(p.x), p.y * std::sin(p.x)};
  };
  const MultiPolygon quarter = mapped_extent(rectangle(0, 1, M_PI / 2, 2), polar);
  ASSERT_EQ(quarter.size(), 1U);
  const Box box = box_of(quarter[0].outer);
  EXPECT_NEAR(box.high.x, 2, 1e-12);
  EXPECT_NEAR(box.high.y, 2, 1e-12);
  for (const double angle : {0.1, 0.7, 1.5}) {
    const auto at = [&](double radius) {
      return locate(quarter[0].outer, {radius * std::cos(angle), radius * std::sin(angle)});
    };
    EXPECT_EQ(at(0.9999), Where::outside);
    EXPECT_EQ(at(1.0001), Where::inside);
    EXPECT_EQ(at(1.9999), Where::inside);
    EXPECT_EQ(at(2.0001), Where::outside);
  }
}

TEST(RasterGrid, an_extent_loses_what_has_no_place_in_the_raster) {
  const auto southern = [](std::vector<Point>& points) {
    for (Point& p : points) p.y = p.y > 5 ? std::numeric_limits<double>::quiet_NaN() : p.y;
  };
  const MultiPolygon rest = mapped_extent(rectangle(0, 0, 10, 10), southern);
  const Box box = box_of(rest[0].outer);
  EXPECT_EQ(box.low, (Point{0, 0}));
  EXPECT_EQ(box.high.x, 10);
  EXPECT_NEAR(box.high.y, 5, 0.011);
  EXPECT_TRUE(std::all_of(rest[0].outer.begin(), rest[0].outer.end(),
                          [](Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }));
}

}  // namespace
}  // namespace thiessen

#include "map/raster/pixel_positions.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

const auto as_it_is = [](std::vector<Point>&) {};

std::unique_ptr<NearestPlaces> anywhere(Metric metric) {
  return nearest_places(std::vector<Point>{{0, 0}}, metric);
}

PixelBlock random_part(Seeded& seeded, const PixelBlock& block) {
  PixelBlock part;
  part.columns = static_cast<int>(seeded.whole(1, block.columns));
  part.rows = static_cast<int>(seeded.whole(1, block.rows));
  part.column = block.column + static_cast<int>(seeded.whole(0, block.columns - part.columns));
  part.row = block.row + static_cast<int>(seeded.whole(0, block.rows - part.rows));
  return part;
}

/// Every centre of a part's pixels lies in its ball, and the balls are no wider than twice the
/// parts.
void expect_balls_hold_their_pixels(Seeded& seeded, const PixelGrid& grid, const PixelBlock& block,
                                    const PointMapping& to_study, const NearestPlaces& places) {
  const auto positions = PixelPositions::fit(grid, block, to_study, places);
  ASSERT_TRUE(positions);
  for (int i = 0; i < 30; ++i) {
    const PixelBlock part = i == 0 ? block : random_part(seeded, block);
    const Ball ball = positions->ball(part);
    std::vector<Point> centres;
    for (int row = part.row; row < part.row + part.rows; ++row) {
      for (int column = part.column; column < part.column + part.columns; ++column)
        centres.push_back(grid.centre(column, row));
    }
    to_study(centres);
    double farthest = 0;
    for (const Point p : centres)
      farthest = std::max(farthest, length(places.in_space(p) - ball.centre));
    ASSERT_LE(farthest, ball.radius);
    const PixelPlane plane = positions->plane(part);
    for (std::size_t k = 0; k < centres.size(); ++k) {
      const auto columns = static_cast<std::size_t>(part.columns);
      const Direction on_plane = plane.first + static_cast<double>(k % columns) * plane.east +
                                 static_cast<double>(k / columns) * plane.south;
      ASSERT_LE(length(places.in_space(centres[k]) - on_plane), plane.off);
    }
    ASSERT_TRUE(part.columns <= 3 || part.rows <= 3 || ball.radius < 2 * farthest);
  }
}

TEST(PixelPositions, hold_longitudes_and_latitudes_of_any_size) {
  Seeded seeded;
  const auto earth = anywhere(Metric::geodesic);
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    PixelGrid grid;
    grid.pixel = std::pow(10, seeded.uniform(-6, -1.5));
    grid.columns = grid.rows = 200;
    grid.north_west = {seeded.uniform(-200, 400), seeded.uniform(-80, 85)};
    const PixelBlock block{static_cast<int>(seeded.whole(0, 72)),
                           static_cast<int>(seeded.whole(0, 72)), 128, 128};
    expect_balls_hold_their_pixels(seeded, grid, block, as_it_is, *earth);
    if (HasFailure()) return;
  }
}

TEST(PixelPositions, hold_curved_projections) {
  Seeded seeded;
  const auto earth = anywhere(Metric::geodesic);
  // Mercator's on the sphere, in degrees at the equator.
  const auto mercator = [](std::vector<Point>& points) {
    for (Point& p : points) p.y = std::atan(std::sinh(p.y * M_PI / 180)) * 180 / M_PI;
  };
  for (std::uint64_t round = 0; round < seeded.rounds(100); ++round) {
    PixelGrid grid;
    grid.pixel = std::pow(10, seeded.uniform(-6, -1));
    grid.columns = grid.rows = 64;
    grid.north_west = {seeded.uniform(-180, 180), seeded.uniform(-150, 150)};
    expect_balls_hold_their_pixels(seeded, grid, {0, 0, 64, 64}, mercator, *earth);
    if (HasFailure()) return;
  }
}

TEST(PixelPositions, hold_planes_far_from_the_origin) {
  Seeded seeded;
  const auto plane = anywhere(Metric::planar);
  for (const double size : {1e-40, 1e-3, 1.0, 1e50}) {
    for (const double away : {0.0, 1.0, 1e6, 1e12}) {
      const PixelGrid grid{{away * size, -away * size}, size / 3, 100, 100};
      expect_balls_hold_their_pixels(seeded, grid, {3, 5, 97, 64}, as_it_is, *plane);
    }
  }
}

TEST(PixelPositions, are_not_fitted_over_a_gap_or_an_end) {
  const auto plane = anywhere(Metric::planar);
  const PixelGrid grid{{0, 64}, 1, 64, 64};
  const PixelBlock block{0, 0, 64, 64};
  ASSERT_TRUE(PixelPositions::fit(grid, block, as_it_is, *plane));
  const auto gap = [](std::vector<Point>& points) {
    for (Point& p : points) p.x += p.x > 40 ? 3 : 0;
  };
  EXPECT_FALSE(PixelPositions::fit(grid, block, gap, *plane));
  EXPECT_TRUE(PixelPositions::fit(grid, {0, 0, 40, 64}, gap, *plane));
  const auto end = [](std::vector<Point>& points) {
    for (Point& p : points) p.y = p.y < 5 ? std::numeric_limits<double>::quiet_NaN() : p.y;
  };
  EXPECT_FALSE(PixelPositions::fit(grid, block, end, *plane));
  EXPECT_TRUE(PixelPositions::fit(grid, {0, 0, 64, 59}, end, *plane));
  const auto bend = [](std::vector<Point>& points) {
    for (Point& p : points) p.x = std::exp(p.x / 10);
  };
  EXPECT_FALSE(PixelPositions::fit(grid, block, bend, *plane));
}

}  // namespace
}  // namespace thiessen

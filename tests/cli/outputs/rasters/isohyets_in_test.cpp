#include "cli/outputs/rasters/isohyets_in.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "cli/outputs/given_inputs.h"
#include "cli/outputs/rasters/raster_of.h"

namespace thiessen::cli {
namespace {

/// Gauges at the corners of a rectangle round the basin or across it.
GivenFiles files(double west = -50, double east = 60) {
  GivenFiles files;
  files.stations = "id,x,y\n";
  int number = 0;
  for (const double x : {west, east}) {
    for (const double y : {-50.0, 50.0})
      files.stations +=
          std::to_string(++number) + "," + std::to_string(x) + "," + std::to_string(y) + "\n";
  }
  return files;
}

GaugeReadings slope(double west = -50, double east = 60) {
  return {{west, west, east, east}, "2013-08-01"};
}

SurfaceRaster sloped(const GivenInputs& given, const RasterSize& size) {
  return surface_raster(given.inputs, slope(), SurfaceMethod::linear, SurfaceRows::Beyond::nearest,
                        size, 1);
}

// The basin is 10 wide and 4 high; lines end at pixels' centres, so that two more on each side are
// needed.
TEST(IsohyetsIn, a_raster_reaches_two_pixels_beyond_the_study_area) {
  const GivenInputs given(files());
  const SurfaceRaster raster = sloped(given, {1, 0});
  EXPECT_EQ(raster.grid.columns, 14);
  EXPECT_EQ(raster.grid.rows, 8);
  EXPECT_EQ(raster.grid.centre(0, 0), (Point{-1.5, 5.5}));
  ASSERT_EQ(raster.values.size(), 14U * 8);
  for (std::size_t i = 0; i < raster.values.size(); ++i) {
    const auto column = static_cast<double>(i % 14);
    EXPECT_NEAR(raster.values[i], column - 1.5, 1e-5) << i;
  }
  ASSERT_TRUE(raster.range);
  EXPECT_NEAR(raster.range->least, -1.5, 1e-5);
  EXPECT_NEAR(raster.range->largest, 11.5, 1e-5);
}

TEST(IsohyetsIn, a_raster_without_a_resolution_has_so_many_pixels_along_its_longer_side) {
  const SurfaceRaster raster = sloped(GivenInputs(files()), {0, 20});
  EXPECT_EQ(raster.grid.pixel, 0.5);
  EXPECT_EQ(raster.grid.columns, 20 + 4);
  EXPECT_EQ(raster.grid.rows, 8 + 4);
}

TEST(IsohyetsIn, a_raster_may_go_on_beyond_the_gauges) {
  const GivenInputs given(files(2, 8));
  const SurfaceRaster raster = surface_raster(given.inputs, slope(2, 8), SurfaceMethod::linear,
                                              SurfaceRows::Beyond::continued, {1, 0}, 2);
  EXPECT_NEAR(raster.values.at(3), 1.5, 1e-5) << "its centre is 1.5, and the hull's edge at 2";
  EXPECT_NEAR(raster.values.at(4), 2.5, 1e-5);
  ASSERT_TRUE(raster.range);
  EXPECT_NEAR(raster.range->least, 2.5, 1e-5);
  EXPECT_NEAR(raster.range->largest, 7.5, 1e-5);
}

/// The lengths of the isohyets in the basin, by their levels.
std::vector<std::pair<double, double>> lines_of(const GivenInputs& given,
                                                const IsohyetLevels& levels) {
  std::vector<std::pair<double, double>> found;
  for (const Isohyet& isohyet : isohyets_in(given.inputs, slope(), SurfaceMethod::linear, {1, 0},
                                            levels, areas_of(given.inputs), 1)) {
    double length = 0;
    for (const auto& line : isohyet.lines) {
      for (std::size_t i = 1; i < line.size(); ++i) {
        EXPECT_NEAR(line[i].x, isohyet.level, 1e-4);
        length += std::abs(line[i].y - line[i - 1].y);
      }
    }
    found.emplace_back(isohyet.level, std::round(1e6 * length) / 1e6);
  }
  return found;
}

using Lines = std::vector<std::pair<double, double>>;

// They run from edge to edge of the basin, which is 4 high.
TEST(IsohyetsIn, are_at_the_levels_that_lie_among_the_values) {
  const GivenInputs given(files());
  EXPECT_EQ(lines_of(given, {0, {-20, 3.25, 7, 50}}), (Lines{{3.25, 4}, {7, 4}}));
  EXPECT_TRUE(lines_of(given, {0, {50, 60}}).empty());
}

TEST(IsohyetsIn, are_at_multiples_of_an_interval_whatever_the_levels) {
  const GivenInputs given(files());
  Lines found = lines_of(given, {3.5, {1}});
  std::erase_if(found, [](const auto& line) { return line.first == 0; });  // the basin's own edge
  EXPECT_EQ(found, (Lines{{3.5, 4}, {7, 4}}));
}

// Four gauges at the corners of a diamond round (5, 2), of half a diagonal of 4.3, with a reading
// as large as their y. Within it each level is a line of one y; beyond it the nearest gauge's value
// is another.
TEST(IsohyetsIn, end_on_the_hull_in_one_piece) {
  GivenFiles files;
  files.stations = "id,x,y\nW,0.7,2\nS,5,-2.3\nE,9.3,2\nN,5,6.3\n";
  const GivenInputs given(files);
  const GaugeReadings readings{{2, -2.3, 2, 6.3}, "2013-08-01"};
  for (const SurfaceMethod method : {SurfaceMethod::linear, SurfaceMethod::natural}) {
    const auto isohyets = isohyets_in(given.inputs, readings, method, {0.1, 0}, {0, {1, 2.5, 3.5}},
                                      areas_of(given.inputs), 2);
    ASSERT_EQ(isohyets.size(), 3U);
    for (const Isohyet& isohyet : isohyets) {
      ASSERT_EQ(isohyet.lines.size(), 1U) << isohyet.level;
      const double half = 4.3 - std::abs(isohyet.level - 2);
      double west = 5;
      double east = 5;
      for (const Point p : isohyet.lines.front()) {
        EXPECT_NEAR(p.y, isohyet.level, 1e-5);
        west = std::min(west, p.x);
        east = std::max(east, p.x);
      }
      EXPECT_NEAR(west, 5 - half, 1e-5);
      EXPECT_NEAR(east, 5 + half, 1e-5);
    }
  }
}

}  // namespace
}  // namespace thiessen::cli

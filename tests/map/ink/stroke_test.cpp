#include "map/ink/stroke.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numeric>

namespace thiessen {
namespace {

double covered_pixels(const Coverage& layer) {
  return std::accumulate(layer.values.begin(), layer.values.end(), 0.0) / 255;
}

TEST(Stroke, covers_its_length_times_its_width) {
  for (const double width : {1.0, 2.5, 6.0}) {
    for (int degrees = 0; degrees < 180; degrees += 13) {
      Coverage layer(200, 200);
      const double angle = degrees * 3.14159265358979 / 180;
      const double dx = 80 * std::cos(angle);
      const double dy = 80 * std::sin(angle);
      stroke(layer, Point{100 - dx, 100 - dy}, Point{100 + dx, 100 + dy}, width);
      const double round_ends = 3.14159265358979 * width * width / 4;
      const double exact = 160 * width + round_ends;
      EXPECT_NEAR(covered_pixels(layer), exact, 0.05 * exact + 1) << degrees << " degrees";
    }
  }
}

TEST(Stroke, drawn_twice_looks_like_once) {
  Coverage once(50, 50);
  stroke(once, Point{3, 4}, Point{45, 31}, 1.5);
  Coverage twice = once;
  stroke(twice, Point{3, 4}, Point{45, 31}, 1.5);
  EXPECT_EQ(once.values, twice.values);
}

TEST(Stroke, reaches_into_the_layer_from_far_outside) {
  Coverage layer(20, 20);
  stroke(layer, Point{-1e9, 10}, Point{1e9, 10}, 2);
  EXPECT_NEAR(covered_pixels(layer), 40, 1);
  Coverage beside(20, 20);
  stroke(beside, Point{-1e9, 40}, Point{1e9, 40}, 2);
  EXPECT_EQ(covered_pixels(beside), 0);
}

TEST(Stroke, line_keeps_its_last_point_however_close) {
  Coverage layer(20, 20);
  const std::array<Point, 4> line{Point{5, 5}, Point{15, 5}, Point{15.1, 5}, Point{15.2, 5.1}};
  stroke(layer, line, 1);
  EXPECT_GT(layer.at(10, 5), 0);
  EXPECT_GT(layer.at(14, 5), 0);
}

}  // namespace
}  // namespace thiessen

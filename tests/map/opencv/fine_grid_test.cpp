#include "map/opencv/fine_grid.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace thiessen {
namespace {

constexpr int unit = 1 << fine::shift;  // of OpenCV's whole numbers, to a fine pixel

// OpenCV's 0 is the middle of the first fine pixel, half of one from the corner.
TEST(FineGrid, places_count_from_the_middle_of_the_first_fine_pixel) {
  EXPECT_EQ(fine::place({0.5, 0.5}, {0, 0}, 1), cv::Point(0, 0));
  EXPECT_EQ(fine::place({0, 0}, {0, 0}, 1), cv::Point(-unit / 2, -unit / 2));
  EXPECT_EQ(fine::place({1, 2}, {0, 0}, 4), cv::Point(7 * unit / 2, 15 * unit / 2));
  EXPECT_EQ(fine::place({101, 202}, {100, 200}, 4), cv::Point(7 * unit / 2, 15 * unit / 2));
  EXPECT_EQ(fine::place({-1, 0}, {0, 0}, 2), cv::Point(-5 * unit / 2, -unit / 2));
}

TEST(FineGrid, places_beyond_whole_numbers_are_as_far_as_these_reach) {
  EXPECT_EQ(fine::place({1e30, -1e30}, {0, 0}, 8), cv::Point(1 << 30, -(1 << 30)));
}

TEST(FineGrid, points_nearer_than_a_third_of_a_pixel_are_passed_over_but_for_the_last) {
  const std::vector<Point> points{{0, 0},   {0.3, 0},  {0.5, 0}, {0.6, 0},
                                  {0.8, 0}, {0.84, 0}, {0.85, 0}};
  const std::vector<cv::Point> places = fine::places(points, {0, 0}, 1);
  ASSERT_EQ(places.size(), 4U);
  const std::array kept{0.0, 0.5, 0.84, 0.85};
  for (std::size_t i = 0; i < kept.size(); ++i)
    EXPECT_EQ(places[i], fine::place({kept[i], 0}, {0, 0}, 1)) << i;
  EXPECT_TRUE(fine::places({}, {0, 0}, 1).empty());
  EXPECT_EQ(fine::places({points.data(), 1}, {0, 0}, 1).size(), 1U);
}

TEST(FineGrid, law_1_a_strip_takes_a_few_megabytes_or_is_one_row) {
  EXPECT_EQ(fine::rows_at_once(1000, 4, 4), 125);  // 8,000,000 / (1000 x 16 x 4)
  for (const int width : {1, 64, 1600, 20'000}) {
    for (const int fineness : {1, 4, 8}) {
      for (const int bytes : {1, 4}) {
        const long long rows = fine::rows_at_once(width, fineness, bytes);
        ASSERT_GE(rows, 1);
        EXPECT_TRUE(rows == 1 || rows * width * fineness * fineness * bytes <= 8'000'000);
      }
    }
  }
  EXPECT_EQ(fine::rows_at_once(20'000, 32, 4), 1);
  EXPECT_GE(fine::rows_at_once(0, 4, 4), 1);
}

TEST(FineGrid, a_rectangle_has_no_negative_sides) {
  EXPECT_EQ(fine::rectangle({3, 4, 5, 6}), cv::Rect(3, 4, 5, 6));
  EXPECT_EQ(fine::rectangle({3, 4, -5, -1}), cv::Rect(3, 4, 0, 0));
}

TEST(FineGrid, colours_are_blue_green_and_red_as_opencv_has_them) {
  EXPECT_EQ(fine::scalar({1, 2, 3}), cv::Scalar(3, 2, 1));
}

/// A pixel of 100, 50 and 0 after the colour was mixed in with this coverage and opacity.
Colour blended(int coverage, Colour colour, int alpha) {
  cv::Mat pixels(1, 1, CV_8UC3, fine::scalar({100, 50, 0}));
  fine::blend(pixels, cv::Mat(1, 1, CV_8UC1, cv::Scalar::all(coverage)), colour, alpha);
  const auto& pixel = pixels.at<cv::Vec3b>(0, 0);
  return {pixel[2], pixel[1], pixel[0]};
}

TEST(FineGrid, law_2_a_colour_is_mixed_in_by_its_coverage_and_its_opacity) {
  EXPECT_EQ(blended(0, {200, 200, 200}, 255), (Colour{100, 50, 0}));
  EXPECT_EQ(blended(255, {200, 0, 255}, 255), (Colour{200, 0, 255}));
  EXPECT_EQ(blended(255, {200, 200, 200}, 0), (Colour{100, 50, 0}));
  // A fifth: 0.2 x 200 + 0.8 x 100, and so on.
  const Colour fifth{120, 80, 40};
  EXPECT_EQ(blended(51, {200, 200, 200}, 255), fifth);
  EXPECT_EQ(blended(255, {200, 200, 200}, 51), fifth);
}

}  // namespace
}  // namespace thiessen

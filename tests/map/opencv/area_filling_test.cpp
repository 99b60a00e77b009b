#include "map/opencv/area_filling.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <vector>

#include "base/interrupt.h"

namespace thiessen {
namespace {

constexpr Colour red{200, 10, 20};
constexpr Colour black{0, 0, 0};
constexpr Colour white{255, 255, 255};

cv::Mat page(int width, int height) {
  return {height, width, CV_8UC3, cv::Scalar::all(255)};
}

Colour colour_at(const cv::Mat& pixels, int x, int y) {
  const auto& pixel = pixels.at<cv::Vec3b>(y, x);
  return {pixel[2], pixel[1], pixel[0]};
}

Ring box(double left, double top, double right, double bottom) {
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

/// The darkness of all pixels, in black ones.
double black_pixels(const cv::Mat& pixels) {
  const cv::Scalar sum = cv::sum(pixels);
  return static_cast<double>(pixels.total()) - (sum[0] + sum[1] + sum[2]) / 765;
}

// A pixel is the mean of a grid four times as fine, whose pixels touched by an outline are filled.
TEST(AreaFilling, law_1_areas_cover_what_they_hold_to_a_fine_pixel_along_their_outlines) {
  const Ring triangle{{20.3, 30.1}, {180.2, 60.7}, {70.9, 190.4}};
  const Area area{{{&triangle, 1}}, black, false, {}};
  const cv::Mat pixels = page(200, 200);
  fill_areas(pixels, {0, 0}, {&area, 1}, {});
  const double exact = ((180.2 - 20.3) * (190.4 - 30.1) - (70.9 - 20.3) * (60.7 - 30.1)) / 2;
  const double outline = 163 + 170 + 168;
  EXPECT_NEAR(black_pixels(pixels), exact, outline / 8 + 5);
}

TEST(AreaFilling, law_2_nothing_shows_between_areas_that_share_an_edge) {
  std::vector<Ring> fan;
  for (int i = 0; i < 24; ++i) {
    const double from = i * M_PI / 12;
    const double to = (i + 1) * M_PI / 12;
    fan.push_back({{100, 100},
                   {100 + 300 * std::cos(from), 100 + 300 * std::sin(from)},
                   {100 + 300 * std::cos(to), 100 + 300 * std::sin(to)}});
  }
  std::vector<Area> areas;
  for (const Ring& ring : fan) areas.push_back({{{&ring, 1}}, red, false, {}});
  const cv::Mat pixels = page(200, 200);
  fill_areas(pixels, {0, 0}, areas, {});
  for (int y = 0; y < 200; ++y) {
    for (int x = 0; x < 200; ++x) ASSERT_EQ(colour_at(pixels, x, y), red) << x << ' ' << y;
  }
}

TEST(AreaFilling, law_3_the_later_area_covers_the_earlier) {
  const Ring under = box(10, 10, 60, 60);
  const Ring over = box(40, 40, 90, 90);
  const std::vector<Area> areas{{{{&under, 1}}, red, false, {}}, {{{&over, 1}}, black, false, {}}};
  const cv::Mat pixels = page(100, 100);
  fill_areas(pixels, {0, 0}, areas, {});
  EXPECT_EQ(colour_at(pixels, 30, 30), red);
  EXPECT_EQ(colour_at(pixels, 50, 50), black);
  EXPECT_EQ(colour_at(pixels, 80, 80), black);
  EXPECT_EQ(colour_at(pixels, 95, 95), white);
}

// Two basins of one gauge may overlap: rings count even and odd within their part alone.
TEST(AreaFilling, law_4_each_part_is_filled_by_itself_with_its_holes) {
  const std::vector<Ring> with_hole{box(10, 10, 90, 90), box(20, 20, 40, 40)};
  const Ring other = box(60, 60, 80, 80);
  const Area area{{with_hole, {&other, 1}}, red, false, {}};
  const cv::Mat pixels = page(100, 100);
  fill_areas(pixels, {0, 0}, {&area, 1}, {});
  EXPECT_EQ(colour_at(pixels, 30, 30), white);
  EXPECT_EQ(colour_at(pixels, 50, 50), red);
  EXPECT_EQ(colour_at(pixels, 70, 70), red);
}

constexpr Hatch stripes{black, 10, 2};

TEST(AreaFilling, law_5_a_hatch_is_of_stripes_from_the_upper_right_to_the_lower_left) {
  const Ring square = box(0, 0, 200, 200);
  const Area area{{{&square, 1}}, red, true, {}};
  const cv::Mat pixels = page(200, 200);
  fill_areas(pixels, {0, 0}, {&area, 1}, stripes);
  double dark = 0;
  for (int y = 1; y < 200; ++y) {
    for (int x = 0; x < 199; ++x) {
      ASSERT_EQ(colour_at(pixels, x, y), colour_at(pixels, x + 1, y - 1)) << x << ' ' << y;
      dark += 1 - colour_at(pixels, x, y).red / 200.0;
    }
  }
  EXPECT_NEAR(dark / (199 * 199), 0.2, 0.03) << "2 pixels of 10";
}

// 1,600 pixels wide, a strip has 78 rows.
TEST(AreaFilling, law_6_strips_join_without_a_seam) {
  const Ring everywhere = box(-9, -9, 2000, 2000);
  const Area area{{{&everywhere, 1}}, red, true, {}};
  const cv::Mat pixels = page(1600, 320);
  fill_areas(pixels, {0, 0}, {&area, 1}, stripes);
  for (int y = 1; y < 320; ++y) {
    for (int x = 0; x < 1599; x += 3)
      ASSERT_EQ(colour_at(pixels, x, y), colour_at(pixels, x + 1, y - 1)) << x << ' ' << y;
  }
}

// Along an outline that OpenCV cuts at the border, up to two of a pixel's 16 fine ones may differ.
TEST(AreaFilling, law_7_a_part_of_the_page_shows_what_the_whole_has_there) {
  const Ring blob{{33.3, 20}, {170, 31.7}, {140, 180.4}, {20, 112.2}};
  const Area area{{{&blob, 1}}, red, true, {}};
  const cv::Mat whole = page(200, 200);
  fill_areas(whole, {0, 0}, {&area, 1}, stripes);
  const cv::Mat part = page(90, 70);
  fill_areas(part, {53, 84}, {&area, 1}, stripes);
  for (int y = 0; y < 70; ++y) {
    for (int x = 0; x < 90; ++x)
      ASSERT_NEAR(colour_at(part, x, y).red, colour_at(whole, x + 53, y + 84).red, 32)
          << x << ' ' << y;
  }
}

TEST(AreaFilling, the_hatch_of_an_area_that_is_covered_does_not_show) {
  const Ring square = box(0, 0, 100, 100);
  const std::vector<Area> areas{{{{&square, 1}}, red, true, {}},
                                {{{&square, 1}}, white, false, {}}};
  const cv::Mat pixels = page(100, 100);
  fill_areas(pixels, {0, 0}, areas, stripes);
  EXPECT_EQ(black_pixels(pixels), 0);
}

TEST(AreaFilling, what_lies_elsewhere_or_holds_nothing_changes_nothing) {
  const Ring far = box(-500, -500, -100, -100);
  const std::vector<Ring> nothing{{}, {}};
  const std::vector<Area> areas{{{{&far, 1}}, black, true, {}}, {{nothing}, black, true, {}}, {}};
  const cv::Mat pixels = page(40, 40);
  fill_areas(pixels, {0, 0}, areas, stripes);
  EXPECT_EQ(black_pixels(pixels), 0);
  fill_areas(pixels, {0, 0}, {}, {});
  EXPECT_EQ(black_pixels(pixels), 0);
}

TEST(AreaFilling, stops_where_a_signal_came) {
  watch_for_interrupts();
  const Ring square = box(0, 0, 9, 9);
  const Area area{{{&square, 1}}, red, false, {}};
  const cv::Mat pixels = page(10, 10);
  std::raise(SIGINT);
  EXPECT_THROW(fill_areas(pixels, {0, 0}, {&area, 1}, {}), Interrupted);
  forget_interrupt();
}

}  // namespace
}  // namespace thiessen

#include "map/opencv/label_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/interrupt.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

void fill(LabelImage& image, std::vector<Ring> rings, std::int32_t label) {
  image.fill(rings, label);
}

/// The labels row by row, as digits; a dot is nobody.
std::vector<std::string> rows_of(const LabelImage& image) {
  std::vector<std::string> rows;
  for (int row = 0; row < image.height(); ++row) {
    rows.emplace_back();
    for (int column = 0; column < image.width(); ++column) {
      const std::int32_t label = image.at(column, row);
      rows.back() += label == LabelImage::nobody ? "." : std::to_string(label);
    }
  }
  return rows;
}

using Rows = std::vector<std::string>;

TEST(LabelImage, begins_with_nobody) {
  const LabelImage image(3, 2);
  EXPECT_EQ(rows_of(image), (Rows{"...", "..."}));
  EXPECT_EQ(image.labels().size(), 6U);
}

TEST(LabelImage, a_shape_has_the_pixels_that_it_touches) {
  LabelImage image(6, 4);
  fill(image, {{{1.2, 1.2}, {3.8, 1.2}, {3.8, 2.8}, {1.2, 2.8}}}, 7);
  EXPECT_EQ(rows_of(image), (Rows{"......", ".777..", ".777..", "......"}));
}

// Else a narrow basin would have no colour and no name.
TEST(LabelImage, one_that_holds_no_centre_has_those_that_it_runs_through) {
  LabelImage image(4, 3);
  fill(image, {{{2.1, -9}, {2.2, -9}, {2.2, 9}, {2.1, 9}}}, 1);
  EXPECT_EQ(rows_of(image), (Rows{"..1.", "..1.", "..1."}));
}

TEST(LabelImage, a_hole_is_nobodys_and_the_last_one_filled_wins) {
  LabelImage image(7, 3);
  fill(image,
       {{{-9, -9}, {99, -9}, {99, 99}, {-9, 99}}, {{1.6, -5}, {4.4, -5}, {4.4, 50}, {1.6, 50}}}, 1);
  EXPECT_EQ(image.at(0, 1), 1);
  EXPECT_EQ(image.at(6, 1), 1);
  EXPECT_EQ(image.at(2, 1), LabelImage::nobody);
  EXPECT_EQ(image.at(3, 1), LabelImage::nobody);
  fill(image, {{{2.2, 1.2}, {6.8, 1.2}, {6.8, 1.8}, {2.2, 1.8}}}, 2);
  EXPECT_EQ(image.at(3, 1), 2);
  EXPECT_EQ(image.at(6, 1), 2);
  EXPECT_EQ(image.at(6, 0), 1);
}

TEST(LabelImage, shapes_beside_it_and_empty_ones_change_nothing) {
  LabelImage image(3, 2);
  fill(image, {{{10, 10}, {20, 10}, {20, 20}}}, 1);
  fill(image, {{{-10, 0}, {-2, 0}, {-2, 2}}}, 1);
  fill(image, {{}, {}}, 1);
  fill(image, {}, 1);
  EXPECT_EQ(rows_of(image), (Rows{"...", "..."}));
}

double distance_to_segment(Point p, Point a, Point b) {
  const Point way{b.x - a.x, b.y - a.y};
  const double square = way.x * way.x + way.y * way.y;
  const double t = std::clamp(((p.x - a.x) * way.x + (p.y - a.y) * way.y) / square, 0.0, 1.0);
  return std::hypot(p.x - a.x - t * way.x, p.y - a.y - t * way.y);
}

TEST(LabelImage, law_1_is_right_but_for_half_a_pixel_within_an_outline_and_two_outside) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(100); ++round) {
    Ring triangle;
    for (int i = 0; i < 3; ++i)
      triangle.push_back({seeded.uniform(-10, 50), seeded.uniform(-10, 50)});
    LabelImage image(40, 40);
    fill(image, {triangle}, 1);
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 40; ++column) {
        const Point centre{column + 0.5, row + 0.5};
        int left = 0;
        double distance = HUGE_VAL;
        for (std::size_t i = 0; i < 3; ++i) {
          const Point a = triangle[i];
          const Point b = triangle[(i + 1) % 3];
          left += (b.x - a.x) * (centre.y - a.y) > (b.y - a.y) * (centre.x - a.x) ? 1 : 0;
          distance = std::min(distance, distance_to_segment(centre, a, b));
        }
        const bool is_inside = left == 0 || left == 3;
        if (is_inside && distance > 0.5) {
          ASSERT_EQ(image.at(column, row), 1) << column << ' ' << row;
        }
        if (!is_inside && distance > 2) {
          ASSERT_EQ(image.at(column, row), LabelImage::nobody) << column << ' ' << row;
        }
      }
    }
  }
}

TEST(LabelImage, stops_where_a_signal_came) {
  watch_for_interrupts();
  LabelImage image(3, 2);
  std::raise(SIGINT);
  EXPECT_THROW(fill(image, {}, 1), Interrupted);
  forget_interrupt();
}

}  // namespace
}  // namespace thiessen

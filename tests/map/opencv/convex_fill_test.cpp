#include "map/opencv/convex_fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

/// Whether the segment comes within `reach` of the point, in columns and in rows.
bool comes_near(Point a, Point b, Point p, double reach) {
  double from = 0;
  double to = 1;
  const auto cut = [&](double start, double step, double middle) {
    if (step == 0) return std::abs(start - middle) <= reach;
    const double enter = (middle - reach - start) / step;
    const double leave = (middle + reach - start) / step;
    from = std::max(from, std::min(enter, leave));
    to = std::min(to, std::max(enter, leave));
    return from <= to;
  };
  return cut(a.x, b.x - a.x, p.x) && cut(a.y, b.y - a.y, p.y);
}

/// The corners of a convex polygon: those of a circle that is stretched and turned.
std::vector<Point> convex(Seeded& seeded) {
  const Point centre{seeded.uniform(-10, 60), seeded.uniform(-10, 50)};
  const double width = std::pow(10, seeded.uniform(-3, 2.5));
  const double height = std::pow(10, seeded.uniform(-3, 1.5));
  const double turn = seeded.uniform(0, 2 * M_PI);
  std::vector<double> angles(3 + seeded.below(6));
  for (double& angle : angles) angle = seeded.uniform(0, 2 * M_PI);
  std::sort(angles.begin(), angles.end());
  std::vector<Point> corners;
  for (const double angle : angles) {
    const double x = width * std::cos(angle);
    const double y = height * std::sin(angle);
    corners.push_back({centre.x + x * std::cos(turn) - y * std::sin(turn),
                       centre.y + x * std::sin(turn) + y * std::cos(turn)});
  }
  return corners;
}

TEST(ConvexFill, fills_what_lies_inside_and_nothing_else_but_along_edges) {
  constexpr int columns = 50;
  constexpr int rows = 40;
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(2000); ++round) {
    std::vector<std::int32_t> image(columns * rows, 7);
    const std::vector<Point> polygon = convex(seeded);
    fill_convex(polygon, 70'000'001, {image.data(), columns, rows, columns});
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        const Point p{static_cast<double>(column), static_cast<double>(row)};
        bool is_inside = true;
        bool is_near = false;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
          const Point a = polygon[i];
          const Point b = polygon[(i + 1) % polygon.size()];
          is_near = is_near || comes_near(a, b, p, filled_beyond);
          is_inside = is_inside && (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x) > 0;
        }
        if (is_near) continue;
        const std::int32_t number = image[static_cast<std::size_t>(row * columns + column)];
        ASSERT_EQ(number, is_inside ? 70'000'001 : 7) << column << " " << row << " " << round;
      }
    }
  }
}

TEST(ConvexFill, leaves_alone_what_lies_beside_the_window) {
  std::vector<std::int32_t> image(100, 0);
  const std::vector<Point> all{{-50, -50}, {50, -50}, {50, 50}, {-50, 50}};
  fill_convex(all, 1, {image.data() + 23, 4, 3, 10});
  for (int i = 0; i < 100; ++i) {
    const bool within = i % 10 >= 3 && i % 10 < 7 && i / 10 >= 2 && i / 10 < 5;
    EXPECT_EQ(image[static_cast<std::size_t>(i)], within ? 1 : 0) << i;
  }
}

}  // namespace
}  // namespace thiessen

#include "map/ink/line_places.h"

#include <gtest/gtest.h>

#include <cmath>

namespace thiessen {
namespace {

TEST(LinePlaces, of_a_line_that_rises_and_then_runs_level_begin_where_it_is_level) {
  const std::vector<Point> line = {{0, 100}, {0, 0}, {100, 0}};
  const auto places = text_places(line, 20);
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places.front(), (Point{10, 0})) << "the first that is level over 20";
  EXPECT_EQ(places.back().x, 0) << "the worst are upright";
}

TEST(LinePlaces, law_1_lie_on_the_line_half_a_text_from_its_ends) {
  std::vector<Point> circle;
  for (int i = 0; i <= 360; ++i) {
    const double angle = i * 3.14159265358979323846 / 180;
    circle.push_back({100 * std::cos(angle), 100 * std::sin(angle)});
  }
  const auto places = text_places(circle, 30);
  EXPECT_NEAR(static_cast<double>(places.size()), (628.3 - 30) / 7.5 + 1, 1);
  for (const Point p : places) EXPECT_NEAR(std::hypot(p.x, p.y), 100, 0.01);
  EXPECT_GT(std::abs(places.front().y), 90) << "at the top or the bottom";
}

TEST(LinePlaces, there_are_none_on_a_line_that_a_text_would_hide) {
  EXPECT_TRUE(text_places(std::vector<Point>{{0, 0}, {39, 0}}, 20).empty());
  EXPECT_FALSE(text_places(std::vector<Point>{{0, 0}, {40, 0}}, 20).empty());
  EXPECT_TRUE(text_places(std::vector<Point>{{5, 5}}, 20).empty());
  EXPECT_TRUE(text_places(std::vector<Point>{}, 20).empty());
  EXPECT_TRUE(text_places(std::vector<Point>{{5, 5}, {5, 5}}, 20).empty());
}

}  // namespace
}  // namespace thiessen

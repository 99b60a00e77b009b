#include "gdal/output/contours.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "base/complaints.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

// 10 x 10 pixels over (0, 0) to (10, 10).
const PixelGrid grid{{0, 10}, 1, 10, 10};

/// Twice the x of the pixels' centres and once their y: its lines of a level have the slope -2.
std::vector<float> slope() {
  std::vector<float> values;
  for (int row = 0; row < 10; ++row) {
    for (int column = 0; column < 10; ++column) {
      const Point centre = grid.centre(column, row);
      values.push_back(static_cast<float>(2 * centre.x + centre.y));
    }
  }
  return values;
}

struct Contour {
  double level;
  std::vector<Point> points;
};

std::vector<Contour> drawn(std::span<const float> values, std::span<const double> levels) {
  const GdalErrors errors;
  const auto contours = contours_of(grid, values, levels, {"the isohyets", ""}, errors);
  std::vector<Contour> found;
  for (const auto& feature : contours->GetLayer(0)) {
    Contour& contour = found.emplace_back();
    contour.level = feature->GetFieldAsDouble(0);
    for (const OGRPoint& point : *feature->GetGeometryRef()->toLineString())
      contour.points.push_back({point.getX(), point.getY()});
  }
  return found;
}

TEST(Contours, law_1_of_a_slope_lie_where_it_has_their_level) {
  const std::array levels{8.25, 14.0, 20.5};
  const auto lines = drawn(slope(), levels);
  ASSERT_EQ(lines.size(), 3U);
  std::vector<double> found;
  for (const Contour& line : lines) {
    found.push_back(line.level);
    ASSERT_GE(line.points.size(), 2U);
    for (const Point p : line.points) {
      // Beyond the outermost centres, half a pixel from the border, a value is its neighbour's.
      if (p.x < 0.5 || p.x > 9.5 || p.y < 0.5 || p.y > 9.5) continue;
      EXPECT_NEAR(2 * p.x + p.y, line.level, 1e-5);
    }
  }
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, std::vector<double>(levels.begin(), levels.end()));
}

TEST(Contours, reach_into_no_pixel_that_is_not_a_number) {
  std::vector<float> values = slope();
  for (std::size_t i = 0; i < 50; ++i) values[i] = std::numeric_limits<float>::quiet_NaN();
  for (const Contour& line : drawn(values, std::array{8.25, 14.0})) {
    for (const Point p : line.points) EXPECT_LE(p.y, 5);
  }
  const std::vector<float> none(100, std::numeric_limits<float>::quiet_NaN());
  EXPECT_TRUE(drawn(none, std::array{1.0}).empty());
}

TEST(Contours, of_levels_that_the_raster_lacks_are_none) {
  EXPECT_TRUE(drawn(slope(), std::array{-1.0, 100.0}).empty());
}

// As it is printed with a comma in a Turkish locale, GDAL would read two levels of it.
TEST(Contours, take_levels_with_every_digit_in_any_locale) {
  const double level = std::nextafter(14.1, 15);
  const auto lines = drawn(slope(), {&level, 1});
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].level, level);
}

TEST(Contours, that_gdal_cannot_draw_are_an_error_with_its_reason) {
  GdalErrors errors;
  const Drawing surface{"the surface", "map.svg"};
  EXPECT_NO_THROW(require_drawn(true, surface, errors));
  EXPECT_TRUE(contains(complaint_of([&] { require_drawn(false, surface, errors); }),
                       "map.svg: GDAL cannot draw the surface"));
  errors.hear(true, "no memory for it.");
  EXPECT_EQ(complaint_of([&] {
              require_drawn(true, {"the isohyets", ""}, errors);
            }),
            "GDAL cannot draw the isohyets: no memory for it");
}

}  // namespace
}  // namespace thiessen

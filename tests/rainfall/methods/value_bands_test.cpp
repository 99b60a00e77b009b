#include "rainfall/methods/value_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double everything = std::numeric_limits<double>::infinity();

double area(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    sum += (a.x * b.y - b.x * a.y) / 2;
  }
  return sum;
}

/// Holes run clockwise, so their areas are negative.
double area(const MultiPolygon& shape) {
  double sum = 0;
  for (const Polygon& part : shape) {
    sum += area(part.outer);
    for (const Ring& hole : part.holes) sum += area(hole);
  }
  return sum;
}

/// The values of a field at the centres of 21 x 21 pixels from (0, 0) to (20, 20).
template <typename Field>
std::vector<float> sampled(const PixelGrid& grid, const Field& field) {
  std::vector<float> values;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column)
      values.push_back(static_cast<float>(field(grid.centre(column, row))));
  }
  return values;
}

const PixelGrid grid{{-0.5, 20.5}, 1, 21, 21};

TEST(ValueBands, of_a_plane_are_stripes) {
  const auto values = sampled(grid, [](Point p) { return p.x + p.y; });
  const PixelValues surface{grid, values};
  EXPECT_NEAR(area(ground_between(surface, -everything, everything)), 400, 1e-9);
  // The corner below 7, a triangle; between 7 and 20.5 in the middle.
  EXPECT_NEAR(area(ground_between(surface, -everything, 7)), 24.5, 1e-9);
  EXPECT_NEAR(area(ground_between(surface, 7, 20)), 200 - 24.5, 1e-9);
  EXPECT_NEAR(area(ground_between(surface, 20, 33.5)), 200 - 6.5 * 6.5 / 2, 1e-9);
  EXPECT_TRUE(ground_between(surface, 41, everything).empty());
}

// A cone of height 9: its rings are a disc with a hole, whose areas are those of circles.
TEST(ValueBands, round_a_summit_have_a_hole) {
  const auto values = sampled(grid, [](Point p) { return 9 - std::hypot(p.x - 10.3, p.y - 9.8); });
  const PixelValues surface{grid, values};
  const MultiPolygon ring = ground_between(surface, 2, 5);
  ASSERT_EQ(ring.size(), 1U);
  ASSERT_EQ(ring[0].holes.size(), 1U);
  EXPECT_NEAR(area(ring), M_PI * (49 - 16), 1);
  EXPECT_EQ(ground_between(surface, 5, everything).size(), 1U);
}

// Every value equals a level, so every crossing is a pixel's centre.
TEST(ValueBands, of_whole_numbers_part_the_ground_at_whole_levels) {
  Seeded seeded;
  const auto values = sampled(grid, [&](Point) { return static_cast<double>(seeded.below(4)); });
  const PixelValues surface{grid, values};
  double sum = 0;
  for (const double level : {0.0, 1.0, 2.0, 3.0})
    sum += area(ground_between(surface, level, level + 1));
  EXPECT_NEAR(sum, 400, 1e-9);
}

TEST(ValueBands, law_1_bands_of_any_values_fill_the_ground) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(20); ++round) {
    const auto values = sampled(grid, [&](Point) { return seeded.uniform(0, 10); });
    // A disc, and some pixels without a value outside of it.
    const auto holds = [](Point p) { return std::hypot(p.x - 9.7, p.y - 10.2) < 7.3; };
    std::vector<std::uint8_t> is_within;
    for (const float inside : sampled(grid, [&](Point p) { return holds(p) ? 1.0 : 0.0; }))
      is_within.push_back(inside > 0 ? 1 : 0);
    const PixelValues disc{grid, values, is_within, holds};
    double sum = 0;
    for (const double level : {0.0, 2.5, 5.0, 5.5, 7.5})
      sum += area(ground_between(disc, level,
                                 level == 7.5 ? 20
                                 : level == 5 ? 5.5
                                              : level + (level == 5.5 ? 2 : 2.5)));
    EXPECT_NEAR(sum, area(ground_between(disc, -everything, everything)), 1e-9);
    EXPECT_NEAR(sum, M_PI * 7.3 * 7.3, 2) << "corners of the disc's edge are cut between centres";
    for (const Polygon& part : ground_between(disc, -everything, everything)) {
      for (const Point p : part.outer) EXPECT_LT(std::hypot(p.x - 9.7, p.y - 10.2), 7.3);
    }
  }
}

TEST(ValueBands, leave_out_what_has_no_value) {
  std::vector<float> values(static_cast<std::size_t>(21) * 21, 1.0F);
  values[21 * 10 + 10] = std::numeric_limits<float>::quiet_NaN();
  const MultiPolygon ground = ground_between({grid, values}, 0, 2);
  ASSERT_EQ(ground.size(), 1U);
  ASSERT_EQ(ground[0].holes.size(), 1U);
  EXPECT_NEAR(area(ground), 400 - 4, 1e-12) << "the four squares round it";
}

}  // namespace
}  // namespace thiessen

#include "rainfall/normals/pixel_integrals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "geometry/polygon.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

WindowValues values_of(std::size_t columns, std::size_t rows,
                       const std::function<double(std::size_t row, std::size_t column)>& value) {
  WindowValues values(columns, rows, 1, true);
  for (std::size_t r = 0; r < rows; ++r) {
    for (std::size_t c = 0; c < columns; ++c) values.set(0, r, c, value(r, c));
  }
  return values;
}

PixelIntegrals plane_of(WindowValues values, double reference) {
  return {std::move(values), {reference}, std::make_unique<EqualPixels>(1)};
}

/// The figures of ground in the order of its corners, which run counter-clockwise in a picture
/// whose rows go down.
std::vector<double> figures_of(const PixelIntegrals& pixels, const Ring& ring) {
  std::vector<double> figures(pixels.figures(), 0);
  for (std::size_t i = 0; i < ring.size(); ++i)
    pixels.add_edge(ring[i], ring[(i + 1) % ring.size()], figures);
  return figures;
}

/// The part of a convex polygon on one side of a line along an axis, by cutting edge by edge
/// (Sutherland and Hodgman).
Ring cut(const Ring& ring, const std::function<double(Point)>& side) {
  Ring kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    const double at_a = side(a);
    const double at_b = side(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
      const double along = at_a / (at_a - at_b);
      kept.push_back({a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)});
    }
  }
  return kept;
}

double area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    twice += a.x * b.y - b.x * a.y;
  }
  return std::abs(twice) / 2;
}

double area_in_pixel(const Ring& ring, double row, double column) {
  Ring part = cut(ring, [&](Point p) { return p.x - column; });
  part = cut(part, [&](Point p) { return column + 1 - p.x; });
  part = cut(part, [&](Point p) { return p.y - row; });
  part = cut(part, [&](Point p) { return row + 1 - p.y; });
  return area(part);
}

// The square from (0.5, 0.5) to (2.5, 1.5), counter-clockwise in the picture: down on the left.
TEST(PixelIntegrals, are_those_of_the_hand) {
  // rows: 10 20 40 / 100 200 400
  const PixelIntegrals pixels = plane_of(
      values_of(3, 2,
                [](std::size_t r, std::size_t c) { return (r == 0 ? 10.0 : 100.0) * (1 << c); }),
      0);
  const auto figures = figures_of(pixels, {{0.5, 0.5}, {0.5, 1.5}, {2.5, 1.5}, {2.5, 0.5}});
  EXPECT_DOUBLE_EQ(figures[0], 2);
  // a quarter of 10, 40, 100, 400; half of 20 and 200
  EXPECT_DOUBLE_EQ(figures[1], 0.25 * 550 + 0.5 * 220);
  EXPECT_DOUBLE_EQ(figures[2], 2);
}

TEST(PixelIntegrals, pass_over_pixels_without_a_value) {
  const PixelIntegrals pixels =
      plane_of(values_of(2, 1, [](std::size_t, std::size_t c) { return c == 0 ? none : 7; }), 5);
  const auto figures = figures_of(pixels, {{0.5, 0}, {0.5, 1}, {1.25, 1}, {1.25, 0}});
  EXPECT_DOUBLE_EQ(figures[0], 0.75);
  EXPECT_DOUBLE_EQ(figures[1], 0.25 * 2);
  EXPECT_DOUBLE_EQ(figures[2], 0.25);
  EXPECT_TRUE(std::isnan(pixels.value_at({0.5, 0.5}, 0)));
  EXPECT_EQ(pixels.value_at({1.5, 0.5}, 0), 7);
  EXPECT_TRUE(std::isnan(pixels.value_at({2, 0.5}, 0)));
}

TEST(PixelIntegrals, of_what_equals_its_reference_are_exactly_nothing) {
  Seeded seeded;
  const PixelIntegrals pixels =
      plane_of(values_of(50, 40, [](std::size_t, std::size_t) { return 0.1; }), 0.1);
  const Ring ring{{seeded.uniform(0, 25), seeded.uniform(0, 20)},
                  {seeded.uniform(0, 25), seeded.uniform(20, 40)},
                  {seeded.uniform(25, 50), seeded.uniform(0, 40)}};
  EXPECT_EQ(figures_of(pixels, ring)[1], 0);
}

// Law: against every pixel as a polygon; some pixels have no value, and some ground lies beyond.
TEST(PixelIntegrals, of_triangles_are_those_of_every_pixel) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const std::size_t columns = 1 + seeded.below(60);
    const std::size_t rows = 1 + seeded.below(30);
    const WindowValues values = values_of(columns, rows, [&](std::size_t, std::size_t) {
      return round % 2 == 0 && seeded.below(5) == 0 ? none : seeded.uniform(100, 2000);
    });
    const PixelIntegrals pixels = plane_of(values, 700);
    const double wide = static_cast<double>(columns);
    const double high = static_cast<double>(rows);
    Ring ring;
    for (int i = 0; i < 3; ++i) {
      Point p{seeded.uniform(-0.2 * wide, 1.2 * wide), seeded.uniform(-0.2 * high, 1.2 * high)};
      if (round % 3 == 0) p = {std::floor(p.x), std::floor(p.y)};
      if (round % 6 == 0) p = {std::clamp(p.x, 0.0, wide), std::clamp(p.y, 0.0, high)};
      ring.push_back(p);
    }
    const double turn = (ring[1].x - ring[0].x) * (ring[2].y - ring[0].y) -
                        (ring[2].x - ring[0].x) * (ring[1].y - ring[0].y);
    if (turn > 0) std::swap(ring[1], ring[2]);  // rows go down
    double whole = 0;
    double excess = 0;
    double covered = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        const double part = area_in_pixel(ring, static_cast<double>(r), static_cast<double>(c));
        const double value = values.at(0, r, c);
        whole += part;
        if (std::isnan(value)) continue;
        covered += part;
        excess += part * (value - 700);
      }
    }
    const auto figures = figures_of(pixels, ring);
    const double size = wide * high;
    EXPECT_NEAR(figures[0], whole, 1e-11 * size) << round;
    EXPECT_NEAR(figures[1], excess, 1e-8 * size) << round;
    EXPECT_NEAR(figures[2], covered, 1e-11 * size) << round;
  }
}

// Law: there and back add up to nothing, bit for bit.
// More bands than are summed at once, of which all, or all but one pixel's, have values.
TEST(PixelIntegrals, of_many_bands_are_those_of_each_alone) {
  constexpr std::size_t columns = 20;
  constexpr std::size_t rows = 9;
  constexpr std::size_t bands = 14;
  for (const bool has_hole : {false, true}) {
    for (const bool is_wide : {false, true}) {
      const auto value = [&](std::size_t band, std::size_t r, std::size_t c) {
        if (has_hole && band == 13 && r == 4 && c == 9) return none;
        return static_cast<double>((7 * r + 3 * c + 5 * band) % 11);
      };
      WindowValues all(columns, rows, bands, is_wide);
      std::vector<double> references;
      for (std::size_t band = 0; band < bands; ++band) {
        references.push_back(static_cast<double>(band));
        for (std::size_t r = 0; r < rows; ++r) {
          for (std::size_t c = 0; c < columns; ++c) all.set(band, r, c, value(band, r, c));
        }
      }
      const PixelIntegrals pixels(std::move(all), references, std::make_unique<EqualPixels>(1));
      // One side lies beyond the window.
      const Ring ring{{3.25, 8.5}, {23, 6.75}, {14.5, 0.25}, {-2, 1.5}};
      const std::vector<double> together = figures_of(pixels, ring);
      for (std::size_t band = 0; band < bands; ++band) {
        const auto alone = figures_of(
            plane_of(values_of(columns, rows,
                               [&](std::size_t r, std::size_t c) { return value(band, r, c); }),
                     references[band]),
            ring);
        EXPECT_EQ(together[0], alone[0]);
        EXPECT_EQ(together[PixelIntegrals::excess_of(band)], alone[1]);
        EXPECT_EQ(together[PixelIntegrals::covered_of(band)], alone[2]);
      }
    }
  }
}

TEST(PixelIntegrals, of_an_edge_back_have_the_other_sign) {
  Seeded seeded;
  const PixelIntegrals pixels = plane_of(
      values_of(40, 40, [&](std::size_t, std::size_t) { return seeded.uniform(0, 9); }), 2);
  for (int i = 0; i < 100; ++i) {
    const Point a{seeded.uniform(-5, 45), seeded.uniform(-5, 45)};
    const Point b{seeded.uniform(-5, 45), seeded.uniform(-5, 45)};
    std::vector<double> there(pixels.figures(), 0);
    std::vector<double> back(pixels.figures(), 0);
    pixels.add_edge(a, b, there);
    pixels.add_edge(b, a, back);
    for (std::size_t f = 0; f < there.size(); ++f) EXPECT_EQ(there[f], -back[f]);
  }
}

}  // namespace
}  // namespace thiessen

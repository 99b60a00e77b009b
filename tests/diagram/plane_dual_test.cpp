#include "diagram/plane_dual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "tessellation/cell.h"
#include "tessellation/space_families.h"

namespace thiessen {
namespace {

constexpr double never_ends = std::numeric_limits<double>::infinity();

using Lengths = std::map<std::pair<std::size_t, std::size_t>, double>;

Lengths lengths_of(const Dual& dual) {
  Lengths lengths;
  for (const Border& border : dual.borders)
    lengths[{index(border.first), index(border.second)}] = border.length;
  EXPECT_EQ(lengths.size(), dual.borders.size()) << "each pair once";
  return lengths;
}

TEST(PlaneDual, of_a_square_and_its_middle) {
  const Dual dual = plane_dual(std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}});
  const double slant = std::sqrt(2.0);
  EXPECT_EQ(lengths_of(dual), (Lengths{{{0, 1}, never_ends},
                                       {{1, 2}, never_ends},
                                       {{2, 3}, never_ends},
                                       {{0, 3}, never_ends},
                                       {{0, 4}, slant},
                                       {{1, 4}, slant},
                                       {{2, 4}, slant},
                                       {{3, 4}, slant}}));
  const auto triangle = [](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return DualTriangle{PlaceIndex{a}, PlaceIndex{b}, PlaceIndex{c}};
  };
  EXPECT_EQ(dual.triangles, (std::vector<DualTriangle>{triangle(0, 1, 4), triangle(0, 4, 3),
                                                       triangle(1, 2, 4), triangle(2, 3, 4)}))
      << "counter-clockwise, from the first place on, in rising order";
}

// Four cells meet at the middle: those across from each other touch there and have no border.
TEST(PlaneDual, law_1_cells_that_only_touch_have_no_border) {
  const Dual square = plane_dual(std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_EQ(square.triangles.size(), 2U);
  EXPECT_EQ(
      lengths_of(square),
      (Lengths{
          {{0, 1}, never_ends}, {{1, 2}, never_ends}, {{2, 3}, never_ends}, {{0, 3}, never_ends}}));
  std::vector<Point> tenths;
  for (int i = 0; i < 100; ++i) tenths.push_back({0.1 * (i % 10), 0.1 * (i / 10)});
  for (const Border& border : plane_dual(tenths).borders) {
    EXPECT_GT(border.length, 0.09) << "rounding leaves no short borders in a lattice of tenths";
    EXPECT_EQ((index(border.second) - index(border.first)) % 9, 1U % 9) << "beside or above";
  }
}

TEST(PlaneDual, places_on_a_line_have_endless_borders_and_no_triangles) {
  const Dual line = plane_dual(std::vector<Point>{{0, 0}, {2, 2}, {1, 1}});
  EXPECT_TRUE(line.triangles.empty());
  EXPECT_EQ(lengths_of(line), (Lengths{{{0, 2}, never_ends}, {{1, 2}, never_ends}}));
  EXPECT_TRUE(plane_dual(std::vector<Point>{{3, 4}}).borders.empty());
}

// The edges of a bounded cell close: added up as vectors they are nothing. Each is at right angles
// to the way to its neighbour, so that their lengths times those ways' directions are nothing too.
TEST(PlaneDual, law_2_the_borders_of_a_bounded_cell_close) {
  Seeded seeded;
  for (const Family& family : families::all_in<2>(seeded, 300)) {
    SCOPED_TRACE(family.name);
    std::vector<Point> places = family.points;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const Dual dual = plane_dual(places);
    std::vector<Point> sum(places.size());
    std::vector<double> around(places.size(), 0);
    for (const Border& border : dual.borders) {
      const Point p = places[index(border.first)];
      const Point q = places[index(border.second)];
      const double apart = std::hypot(q.x - p.x, q.y - p.y);
      const Point step{border.length / apart * (q.x - p.x), border.length / apart * (q.y - p.y)};
      sum[index(border.first)] = {sum[index(border.first)].x + step.x,
                                  sum[index(border.first)].y + step.y};
      sum[index(border.second)] = {sum[index(border.second)].x - step.x,
                                   sum[index(border.second)].y - step.y};
      around[index(border.first)] += border.length;
      around[index(border.second)] += border.length;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!std::isfinite(around[i])) continue;
      const double size = std::abs(places[i].x) + std::abs(places[i].y);
      EXPECT_LE(std::hypot(sum[i].x, sum[i].y), 1e-9 * around[i] + 1e-9 * size) << i;
    }
  }
}

TEST(PlaneDual, law_3_does_not_depend_on_the_order_of_places) {
  Seeded seeded;
  std::vector<Point> places = families::uniform(seeded, 200);
  const Dual before = plane_dual(places);
  std::vector<Point> turned(places.rbegin(), places.rend());
  const auto last = static_cast<std::uint32_t>(places.size() - 1);
  Dual after = plane_dual(turned);
  for (Border& border : after.borders) {
    border.first = PlaceIndex{last - static_cast<std::uint32_t>(border.first)};
    border.second = PlaceIndex{last - static_cast<std::uint32_t>(border.second)};
  }
  put_in_order(after);
  EXPECT_EQ(lengths_of(after), lengths_of(before));
}

}  // namespace
}  // namespace thiessen

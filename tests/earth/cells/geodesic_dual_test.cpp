#include "earth/cells/geodesic_dual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "earth/cells/geodesic_diagram.h"
#include "earth/sphere/geodesic.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-6;
constexpr double quarter_meridian = 10001965.729;  // metres, of WGS 84
constexpr double equator = 2 * std::numbers::pi * 6378137;

using Pair = std::pair<std::size_t, std::size_t>;
using Lengths = std::map<Pair, double>;

Lengths lengths_of(const Dual& dual) {
  Lengths lengths;
  for (const Border& border : dual.borders)
    lengths[{index(border.first), index(border.second)}] = border.length;
  EXPECT_EQ(lengths.size(), dual.borders.size()) << "each pair once";
  return lengths;
}

std::set<Pair> sides_of(const std::vector<DualTriangle>& triangles) {
  std::set<Pair> sides;
  for (const DualTriangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({index(t.at(i)), index(t.at((i + 1) % 3))});
      sides.insert({low, high});
    }
  }
  return sides;
}

TEST(GeodesicDual, of_two_places_is_a_closed_border) {
  const Dual across = geodesic_dual(std::vector<Point>{{0, 10}, {0, -10}}, accuracy, 1);
  ASSERT_EQ(across.borders.size(), 1U);
  EXPECT_NEAR(across.borders[0].length, equator, 0.01) << "the equator";
  EXPECT_TRUE(across.triangles.empty());
  const Dual beside = geodesic_dual(std::vector<Point>{{0, 0}, {90, 0}}, accuracy, 1);
  ASSERT_EQ(beside.borders.size(), 1U);
  EXPECT_NEAR(beside.borders[0].length, 4 * quarter_meridian, 0.01) << "a meridian, all round";
  EXPECT_TRUE(geodesic_dual(std::vector<Point>{{5, 5}}, accuracy, 1).borders.empty());
}

// The cells of the four on the equator meet along the meridians between them, up to where the pole
// is as near.
TEST(GeodesicDual, of_an_octahedron) {
  const std::vector<Point> places{{0, 0}, {90, 0}, {180, 0}, {-90, 0}, {0, 90}, {0, -90}};
  const Dual dual = geodesic_dual(places, accuracy, 2);
  EXPECT_EQ(dual.triangles.size(), 8U);
  EXPECT_EQ(dual.borders.size(), 12U);
  double low = 0, high = 90;
  while (high - low > 1e-12) {
    const double middle = (low + high) / 2;
    const Point at{45, middle};
    const bool pole_is_nearer = geodesic_distance(at, places[4]) < geodesic_distance(at, places[0]);
    (pole_is_nearer ? high : low) = middle;
  }
  const Lengths lengths = lengths_of(dual);
  for (const Pair& beside : {Pair{0, 1}, {1, 2}, {2, 3}, {0, 3}})
    EXPECT_NEAR(lengths.at(beside), 2 * geodesic_distance({45, 0}, {45, low}), 0.01);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(lengths.at({i, 4}), lengths.at({0, 4}), 1e-3);
    EXPECT_NEAR(lengths.at({i, 5}), lengths.at({0, 4}), 1e-3);
  }
}

TEST(GeodesicDual, places_on_a_meridian_have_borders_and_no_triangles) {
  const Dual dual = geodesic_dual(std::vector<Point>{{10, 0}, {10, 1}, {10, 2}}, accuracy, 1);
  EXPECT_TRUE(dual.triangles.empty());
  for (const Border& border : dual.borders) EXPECT_NEAR(border.length, 2e7, 2e5);
  const Lengths lengths = lengths_of(dual);
  EXPECT_TRUE(lengths.contains({0, 1}));
  EXPECT_TRUE(lengths.contains({1, 2}));
}

// Seen from the far side of the Earth the hull of a network has triangles of its own, which are
// turned over: a network of a region has those that cover its hull, and no others.
TEST(GeodesicDual, of_a_region_covers_its_hull_once) {
  const std::vector<Point> places{{10, 40}, {11, 40}, {11.2, 41.1}, {10, 41}, {10.5, 40.4}};
  const Dual dual = geodesic_dual(places, accuracy, 1);
  EXPECT_EQ(dual.triangles.size(), 4U);
  EXPECT_EQ(dual.borders.size(), 9U) << "eight sides, and two cells that meet on the far side";
  for (const Pair& side : sides_of(dual.triangles)) EXPECT_TRUE(lengths_of(dual).contains(side));
}

// By symmetry the corners of a lattice's squares lie on one circle each: those across from each
// other only touch.
TEST(GeodesicDual, of_a_lattice_has_no_borders_across) {
  std::vector<Point> places;
  for (int i = 0; i < 100; ++i) places.push_back({10 + 0.1 * (i % 10), 47 + 0.1 * (i / 10)});
  std::size_t beside = 0;
  for (const auto& [pair, length] : lengths_of(geodesic_dual(places, accuracy, 1))) {
    EXPECT_GT(length, 20 * accuracy);
    const std::size_t columns = pair.second % 10 > pair.first % 10
                                    ? pair.second % 10 - pair.first % 10
                                    : pair.first % 10 - pair.second % 10;
    const std::size_t rows = pair.second / 10 - pair.first / 10;
    EXPECT_FALSE(columns == 1 && rows == 1) << pair.first << ' ' << pair.second << ' ' << length;
    if (columns + rows == 1) ++beside;
  }
  EXPECT_EQ(beside, 180U);
}

TEST(GeodesicDual, law_1_neighbours_all_over_the_earth_are_sides_of_triangles) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < seeded.rounds(5); ++round) {
    std::vector<Point> places;
    for (int i = 0; i < 60; ++i) {
      const double z = seeded.uniform(-1, 1);
      places.push_back({seeded.uniform(-180, 180), std::asin(z) / std::numbers::pi * 180});
    }
    const Dual dual = geodesic_dual(places, accuracy, 2);
    const std::set<Pair> sides = sides_of(dual.triangles);
    for (const auto& [pair, length] : lengths_of(dual))
      EXPECT_TRUE(sides.contains(pair)) << pair.first << ' ' << pair.second << ' ' << length;
    EXPECT_EQ(dual.triangles.size(), 2 * places.size() - 4) << "by Euler's formula";
  }
}

// The chords of the cells that are drawn, each within five centimetres of the border: added up,
// those of a pair are as long, to the square of that. Borders that come near the sides of the map
// are left out, for they are drawn on both.
TEST(GeodesicDual, law_2_borders_are_as_long_as_the_edges_that_are_drawn) {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 60; ++i) {
    const double z = seeded.uniform(-1, 1);
    places.push_back({seeded.uniform(-180, 180), std::asin(z) / std::numbers::pi * 180});
  }
  const Lengths lengths = lengths_of(geodesic_dual(places, accuracy, 1));
  const Diagram drawn = geodesic_diagram(places, {{-180, -90}, {180, 90}}, 0.05, accuracy, 1);
  Lengths sums;
  std::set<Pair> at_sides;
  for (const Chord& chord : drawn.chords) {
    const Point a = drawn.nodes[chord.from];
    const Point b = drawn.nodes[chord.to];
    const auto [low, high] = std::minmax({index(chord.left), index(chord.right)});
    const bool is_at_side =
        std::max(std::abs(a.x), std::abs(b.x)) > 179 || std::max(std::abs(a.y), std::abs(b.y)) > 89;
    if (is_at_side) at_sides.insert({low, high});
    sums[{low, high}] += geodesic_distance(a, b);
  }
  std::size_t compared = 0;
  for (const auto& [pair, length] : lengths) {
    if (at_sides.contains(pair)) continue;
    ASSERT_TRUE(sums.contains(pair));
    EXPECT_NEAR(length, sums.at(pair), 1e-6 * length + 0.1) << pair.first << ' ' << pair.second;
    ++compared;
  }
  EXPECT_GT(compared, 100U);
}

TEST(GeodesicDual, law_3_depends_on_neither_threads_nor_the_order_of_places) {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 200; ++i) places.push_back({seeded.uniform(5, 15), seeded.uniform(45, 55)});
  const Dual one = geodesic_dual(places, accuracy, 1);
  EXPECT_EQ(lengths_of(one), lengths_of(geodesic_dual(places, accuracy, 3)));
  Dual turned = geodesic_dual(std::vector<Point>(places.rbegin(), places.rend()), accuracy, 1);
  const auto last = static_cast<std::uint32_t>(places.size() - 1);
  for (Border& border : turned.borders) {
    border.first = PlaceIndex{last - static_cast<std::uint32_t>(border.first)};
    border.second = PlaceIndex{last - static_cast<std::uint32_t>(border.second)};
  }
  put_in_order(turned);
  EXPECT_EQ(lengths_of(turned), lengths_of(one));
}

}  // namespace
}  // namespace thiessen

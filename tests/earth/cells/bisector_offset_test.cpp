// The polynomial that stands for a piece of an edge: judged by Karney's distances.
#include "earth/cells/bisector_offset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "earth/random_points.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-4;  // metres

GeodesicBisector edge_between(Point a, Point b) {
  const EarthPoint first(a);
  const EarthPoint second(b);
  return {first, second, {first.direction, second.direction}, accuracy};
}

std::optional<BisectorOffset> fitted(const GeodesicBisector& edge, double from, double to) {
  return BisectorOffset::fit(edge, from, edge.find(from).position, to, edge.find(to).position);
}

// A point that is off by ten times the accuracy is nearer to one place than to the other by twice
// that at most; between samples a half more is allowed for.
constexpr double unequal = 1.5 * 2 * 10 * accuracy;

TEST(BisectorOffset, law_1_its_points_are_as_far_from_both_places) {
  Seeded seeded;
  std::size_t fits = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    const Point a = random_point(seeded);
    const Point b = random_point_at(seeded, a, std::pow(10, seeded.uniform(2, 6)));
    const GeodesicBisector edge = edge_between(a, b);
    const double from = seeded.uniform(-0.6, 0.5);
    const double to = from + std::pow(10, seeded.uniform(-4, -1));
    const auto offset = fitted(edge, from, to);
    if (!offset) continue;
    ++fits;
    for (int i = 0; i <= 10; ++i) {
      const Point p = offset->at(from + i / 10. * (to - from));
      ASSERT_NEAR(geodesic_distance(a, p), geodesic_distance(b, p), unequal);
    }
  }
  EXPECT_GT(fits, Seeded::rounds(250));
}

// All round the Earth, where pieces are as long as edges are drawn in, and near the antipodes some
// cannot be told.
TEST(BisectorOffset, law_2_a_piece_is_refused_rather_than_wrong) {
  Seeded seeded;
  std::size_t refused = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const Point a = random_point(seeded);
    const Point b = random_point_at(seeded, a, std::pow(10, seeded.uniform(3, 7)));
    const GeodesicBisector edge = edge_between(a, b);
    const double from = seeded.uniform(-std::numbers::pi, std::numbers::pi);
    const double to = from + seeded.uniform(0.02, 0.2);
    const auto offset = fitted(edge, from, to);
    if (!offset) {
      ++refused;
      continue;
    }
    for (int i = 0; i <= 20; ++i) {
      const Point p = offset->at(from + i / 20. * (to - from));
      ASSERT_NEAR(geodesic_distance(a, p), geodesic_distance(b, p), unequal);
    }
  }
  EXPECT_GT(refused, Seeded::rounds(2));
  EXPECT_LT(refused, Seeded::rounds(40));
}

TEST(BisectorOffset, law_3_at_its_ends_it_is_where_it_was_told_to_be) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const Point a = random_point(seeded);
    const GeodesicBisector edge = edge_between(a, random_point_at(seeded, a, 50'000));
    const double from = seeded.uniform(-0.5, 0.5);
    const auto offset = fitted(edge, from, from + 0.01);
    ASSERT_TRUE(offset);
    EXPECT_LT(geodesic_distance(offset->at(from), edge.find(from).position), 1e-6);
    EXPECT_LT(geodesic_distance(offset->at(from + 0.01), edge.find(from + 0.01).position), 1e-6);
  }
}

TEST(BisectorOffset, law_4_a_piece_without_length_and_one_at_the_antipodes_are_refused) {
  const GeodesicBisector edge = edge_between({10, 47}, {10.01, 47.01});
  const Point start = edge.find(0.1).position;
  EXPECT_FALSE(BisectorOffset::fit(edge, 0.1, start, 0.1, start));
  EXPECT_FALSE(BisectorOffset::fit(edge, 0.1, start, 0.05, start));
  const double pi = std::numbers::pi;
  EXPECT_FALSE(fitted(edge, pi - 1e-3, pi + 1e-3));
}

TEST(BisectorOffset, of_places_mirrored_by_the_equator_is_the_equator) {
  const auto offset = fitted(edge_between({20, 3}, {20, -3}), -1, 1.2);
  ASSERT_TRUE(offset);
  for (const double angle : {-0.7, 0.0, 0.4, 1.1}) {
    EXPECT_NEAR(offset->at(angle).y, 0, 1e-10);
    EXPECT_NEAR(offset->at(angle).x, 20 + angle * 180 / M_PI, 1e-9);
  }
}

}  // namespace
}  // namespace thiessen

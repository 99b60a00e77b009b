// Short edges: judged by the distances of their places, by Karney's method.
#include "earth/cells/short_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "earth/area/ellipsoid_area.h"
#include "earth/cells/geodesic_bisector.h"
#include "earth/random_points.h"
#include "earth/sphere/conformal_sphere.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-6;  // metres

/// Two places, and their bisector from one angle to another.
struct Between {
  Between(Point its_a, Point its_b, double from, double to)
      : a(its_a), b(its_b), edge(a, b, {a.direction, b.direction}, accuracy) {
    start = end_at(from);
    end = end_at(to);
  }
  EdgeEnd end_at(double angle) const {
    const Point p = edge.find(angle).position;
    return {p, on_sphere(p)};
  }
  std::optional<ShortEdge> fit() const {
    return ShortEdge::fit(a.direction, b.direction, start, end);
  }
  double unequal(Point p) const {
    return geodesic_distance(a.position, p) - geodesic_distance(b.position, p);
  }

  EarthPoint a;
  EarthPoint b;
  GeodesicBisector edge;
  EdgeEnd start;
  EdgeEnd end;
};

Between anywhere(Seeded& seeded, double longest) {
  const double highest = ShortEdge::highest_latitude - 0.1;
  const Point a{seeded.uniform(-170, 170), seeded.uniform(-highest, highest)};
  const double apart = std::pow(10, seeded.uniform(3, 4.2));
  const double from = seeded.uniform(-1e-3, 1e-3);
  return {a, random_point_at(seeded, a, apart), from, from + longest * seeded.uniform(0.1, 1)};
}

// A point that is off by a metre is nearer to one place than to the other by as much as they are
// seen apart from there, two metres at most.
TEST(ShortEdge, law_1_its_points_are_as_far_from_both_places) {
  Seeded seeded;
  std::size_t fits = 0;
  for (std::uint64_t round = 0; round < Seeded::rounds(1000); ++round) {
    const Between between = anywhere(seeded, ShortEdge::longest);
    const auto edge = between.fit();
    if (!edge) continue;
    ++fits;
    for (int i = 0; i <= 20; ++i) ASSERT_NEAR(between.unequal(edge->at(i / 20.)), 0, 4e-6) << i;
  }
  EXPECT_GT(fits, Seeded::rounds(900));
}

// Tolerances are told by where points are along the edge, too, but not by hundredths of
// millimetres.
TEST(ShortEdge, law_2_its_points_are_the_bisector_s_at_equal_angles) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const Between between = anywhere(seeded, ShortEdge::longest);
    const auto edge = between.fit();
    if (!edge) continue;
    const auto [from, to] =
        between.edge.arc().between(between.start.direction, between.end.direction);
    ASSERT_NEAR(edge->length(), to - from, 1e-12);
    for (const double share : {0.0, 0.1, 0.25, 0.4, 0.5, 0.75, 0.9, 1.0}) {
      const Point expected = between.edge.find(from + share * (to - from)).position;
      ASSERT_LT(geodesic_distance(edge->at(share), expected), 3e-5);
    }
  }
}

// The area of the polygon between the edge and its chord, in many corners.
TEST(ShortEdge, law_3_the_area_beside_a_chord_is_what_lies_between) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    const Between between = anywhere(seeded, ShortEdge::longest);
    const auto edge = between.fit();
    if (!edge) continue;
    const double middle = seeded.uniform(0.2, 0.8);
    const double part = 2 * std::min(middle, 1 - middle);
    constexpr int corners = 400;
    const auto at = [&](int i) { return edge->at(middle + part * (1. * i / corners - 0.5)); };
    const double reference = at(0).y;
    double area = area_under(at(0), at(corners), reference);
    for (int i = 0; i < corners; ++i) area -= area_under(at(i), at(i + 1), reference);
    ASSERT_NEAR(edge->area_beside_chord(middle, part), area, 1e-4 * std::abs(area) + 1e-3);
  }
}

// As three points tell it.
TEST(ShortEdge, law_3b_its_bend_is_how_far_middles_lie_from_chords) {
  const Between between({10, 50}, {10.02, 50.03}, -5e-4, 6e-4);
  const auto edge = between.fit();
  ASSERT_TRUE(edge);
  const auto to_right = [&](double from, double to) {
    const Point start = edge->at(from), middle = edge->at((from + to) / 2), end = edge->at(to);
    const double metres = 6371008.8 * M_PI / 180;
    const double cosine = std::cos(middle.y * M_PI / 180);
    const Point way{(end.x - start.x) * cosine * metres, (end.y - start.y) * metres};
    const Point half{(middle.x - start.x) * cosine * metres, (middle.y - start.y) * metres};
    return (half.x * way.y - half.y * way.x) / std::hypot(way.x, way.y);
  };
  const auto [whole, first, last] = edge->bend();
  EXPECT_NEAR(whole, to_right(0, 1), 1e-6);
  EXPECT_NEAR(first, to_right(0, 0.5), 1e-6);
  EXPECT_NEAR(last, to_right(0.5, 1), 1e-6);
  EXPECT_GT(std::abs(whole), 0.1);
}

TEST(ShortEdge, law_4_what_is_long_or_far_or_without_length_is_refused) {
  EXPECT_FALSE(Between({10, 50}, {10.02, 50.03}, -2e-3, 2.1e-3).fit());
  EXPECT_FALSE(Between({10, 50}, {10.02, 50.03}, 0.011, 0.012).fit());
  EXPECT_FALSE(Between({10, 50}, {12.2, 50.03}, 0, 1e-3).fit());
  EXPECT_FALSE(Between({10, 50}, {10.02, 50.03}, 1e-4, 1e-4).fit());
  EXPECT_FALSE(Between({10, 50}, {10.02, 50.03}, 1e-4, 0).fit());
  EXPECT_FALSE(Between({10, 74}, {10.02, 74.03}, -1e-3, 1e-3).fit());
}

}  // namespace
}  // namespace thiessen

#include "basin/ring_linking.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "basin/shapes.h"

namespace thiessen {
namespace {

void add_ring(std::vector<DirectedEdge>& edges, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

MultiPolygon linked(const std::vector<Ring>& rings) {
  std::vector<DirectedEdge> edges;
  for (const Ring& ring : rings) add_ring(edges, ring);
  Seeded seeded;
  std::shuffle(edges.begin(), edges.end(), seeded.generator());
  MultiPolygon parts = link_rings(std::move(edges));
  std::sort(parts.begin(), parts.end(), [](const Polygon& a, const Polygon& b) {
    return *std::min_element(a.outer.begin(), a.outer.end()) <
           *std::min_element(b.outer.begin(), b.outer.end());
  });
  return parts;
}

Ring from_least(Ring ring) {
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

TEST(RingLinking, of_nothing_is_nothing) {
  EXPECT_TRUE(link_rings(std::vector<DirectedEdge>()).empty());
}

TEST(RingLinking, joins_the_edges_of_a_ring) {
  const Ring square = shapes::rectangle({0, 0}, {1, 1});
  const MultiPolygon parts = linked({square});
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(from_least(parts[0].outer), square);
  EXPECT_TRUE(parts[0].holes.empty());
}

TEST(RingLinking, puts_each_hole_into_the_smallest_part_round_it) {
  const Ring sea = shapes::rectangle({0, 0}, {10, 10});
  const Ring lake = shapes::reversed(shapes::rectangle({1, 1}, {9, 9}));
  const Ring island = shapes::rectangle({2, 2}, {8, 8});
  const Ring pond = shapes::reversed(shapes::rectangle({3, 3}, {4, 4}));
  const Ring other_pond = shapes::reversed(shapes::rectangle({5, 5}, {6, 6}));
  const MultiPolygon parts = linked({sea, lake, island, pond, other_pond});
  ASSERT_EQ(parts.size(), 2u);
  ASSERT_EQ(parts[0].holes.size(), 1u);
  EXPECT_EQ(from_least(parts[0].holes[0]), from_least(lake));
  EXPECT_EQ(parts[1].holes.size(), 2u);
}

// Two squares that touch in a corner are two parts; a hole that touches the outer ring stays one.
TEST(RingLinking, parts_rings_that_touch_in_a_point) {
  const MultiPolygon squares =
      linked({shapes::rectangle({0, 0}, {1, 1}), shapes::rectangle({1, 1}, {2, 2})});
  ASSERT_EQ(squares.size(), 2u);
  EXPECT_EQ(squares[0].outer.size(), 4u);
  EXPECT_EQ(squares[1].outer.size(), 4u);

  const Ring hole{{0, 0}, {1, 2}, {2, 1}};  // clockwise, from a corner of the square
  const MultiPolygon holed = linked({shapes::rectangle({0, 0}, {4, 4}), hole});
  ASSERT_EQ(holed.size(), 1u);
  EXPECT_EQ(holed[0].outer.size(), 4u);
  ASSERT_EQ(holed[0].holes.size(), 1u);
  EXPECT_EQ(from_least(holed[0].holes[0]), hole);
}

TEST(RingLinking, of_a_hole_that_parts_its_polygon_in_two_makes_two_parts) {
  // From side to side of the square, touching both.
  const Ring hole{{0, 2}, {2, 3}, {4, 2}, {2, 1}};
  const MultiPolygon parts = linked({{{0, 0}, {4, 0}, {4, 2}, {4, 4}, {0, 4}, {0, 2}}, hole});
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].outer.size(), 5u);
  EXPECT_EQ(parts[1].outer.size(), 5u);
  EXPECT_TRUE(parts[0].holes.empty());
}

TEST(RingLinking, of_an_edge_there_and_back_is_nothing) {
  EXPECT_TRUE(linked({{{0, 0}, {1, 1}}}).empty());
}

TEST(RingLinking, of_many_parts_that_meet_in_one_point) {
  std::vector<Ring> petals;
  for (int i = 0; i < 50; ++i) {
    const double angle = 2 * M_PI * i / 50;
    petals.push_back({{0, 0},
                      {std::cos(angle), std::sin(angle)},
                      {std::cos(angle + 0.1), std::sin(angle + 0.1)}});
  }
  EXPECT_EQ(linked(petals).size(), 50u);
}

}  // namespace
}  // namespace thiessen

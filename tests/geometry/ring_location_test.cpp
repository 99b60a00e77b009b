// Where points lie against a ring: exactly, whichever way the ring runs and wherever it begins.
#include "geometry/ring_location.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

Ring random_ring(Seeded& seeded, std::size_t vertices, int size) {
  Ring ring;
  for (std::size_t i = 0; i < vertices; ++i)
    ring.push_back({static_cast<double>(seeded.whole(-size, size)),
                    static_cast<double>(seeded.whole(-size, size))});
  return ring;
}

TEST(RingLocation, law_1_vertices_and_middles_of_edges_are_on_the_boundary) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const Ring ring = random_ring(seeded, 3 + seeded.below(8), 20);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      EXPECT_EQ(locate(ring, a), Where::boundary);
      EXPECT_EQ(locate(ring, {(a.x + b.x) / 2, (a.y + b.y) / 2}), Where::boundary);
    }
  }
}

TEST(RingLocation, law_2_neither_the_rings_way_nor_its_beginning_matters) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    const Ring ring = random_ring(seeded, 3 + seeded.below(8), 5);
    Ring other = ring;
    std::rotate(other.begin(),
                other.begin() + static_cast<std::ptrdiff_t>(seeded.below(ring.size())),
                other.end());
    if (round % 2 == 0) std::reverse(other.begin(), other.end());
    for (int x = -6; x <= 6; ++x) {
      for (int y = -6; y <= 6; ++y) {
        const Point p{static_cast<double>(x), static_cast<double>(y)};
        EXPECT_EQ(locate(ring, p), locate(other, p));
      }
    }
  }
}

// The sum of the angles under which the edges are seen is a whole number of turns.
TEST(RingLocation, law_3_off_the_boundary_inside_is_an_odd_number_of_turns) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(300); ++round) {
    const Ring ring = random_ring(seeded, 3 + seeded.below(8), 5);
    const Point p{seeded.uniform(-6, 6), seeded.uniform(-6, 6)};
    double turned = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      const double cross = (a.x - p.x) * (b.y - p.y) - (a.y - p.y) * (b.x - p.x);
      const double dot = (a.x - p.x) * (b.x - p.x) + (a.y - p.y) * (b.y - p.y);
      turned += std::atan2(cross, dot);
    }
    const bool is_odd = std::lround(turned / (2 * M_PI)) % 2 != 0;
    EXPECT_EQ(locate(ring, p), is_odd ? Where::inside : Where::outside);
  }
}

// A point a rounding away from an edge is not on it.
TEST(RingLocation, law_4_the_last_bit_counts) {
  const Ring ring{{0, 0}, {3, 1}, {0, 4}};
  const Point on_edge{1.5, 0.5};
  EXPECT_EQ(locate(ring, on_edge), Where::boundary);
  EXPECT_EQ(locate(ring, {1.5, std::nextafter(0.5, 1)}), Where::inside);
  EXPECT_EQ(locate(ring, {1.5, std::nextafter(0.5, 0)}), Where::outside);
}

TEST(RingLocation, law_5_what_is_outside_the_box_is_outside_and_a_ring_of_nothing_holds_nothing) {
  const Ring ring{{0, 0}, {3, 1}, {0, 4}};
  const Box box = box_of(ring);
  EXPECT_EQ(box.low, (Point{0, 0}));
  EXPECT_EQ(box.high, (Point{3, 4}));
  EXPECT_EQ(locate(ring, {4, 1}), Where::outside);
  EXPECT_EQ(locate(ring, {-1, 0}), Where::outside);
  EXPECT_EQ(locate({}, {0, 0}), Where::outside);
  EXPECT_TRUE(box_of(Ring{}).empty());
}

}  // namespace
}  // namespace thiessen

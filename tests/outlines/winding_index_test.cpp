// How often rings wind round a point.
#include "outlines/winding_index.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"

namespace thiessen {
namespace {

const Ring square = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};

std::map<std::uint32_t, int> windings(const std::vector<Ring>& rings, Point p) {
  return WindingIndex(rings).at(p);
}

TEST(WindingIndex, law_1_a_ring_counts_1_round_what_lies_to_its_left) {
  EXPECT_EQ(windings({square}, {1, 1}), (std::map<std::uint32_t, int>{{0, 1}}));
  EXPECT_EQ(windings({shapes::reversed(square)}, {1, 1}), (std::map<std::uint32_t, int>{{0, -1}}));
  EXPECT_TRUE(windings({square}, {5, 1}).empty());
  EXPECT_TRUE(windings({square}, {-1, 1}).empty());
  EXPECT_TRUE(WindingIndex({}).at({0, 0}).empty());
}

TEST(WindingIndex, law_2_a_ring_wound_twice_counts_2) {
  Ring twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_EQ(windings({twice}, {1, 1}), (std::map<std::uint32_t, int>{{0, 2}}));
}

TEST(WindingIndex, law_3_the_lobes_of_a_bow_tie_count_opposite) {
  const Ring bow = {{0, 0}, {4, 4}, {4, 0}, {0, 4}};
  EXPECT_EQ(windings({bow}, {0.5, 2}), (std::map<std::uint32_t, int>{{0, 1}}));
  EXPECT_EQ(windings({bow}, {3.5, 2}), (std::map<std::uint32_t, int>{{0, -1}}));
}

/// By the sum of the angles under which the edges are seen.
int by_angles(const Ring& ring, Point p) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    sum += std::remainder(std::atan2(b.y - p.y, b.x - p.x) - std::atan2(a.y - p.y, a.x - p.x),
                          2 * M_PI);
  }
  return static_cast<int>(std::lround(sum / (2 * M_PI)));
}

TEST(WindingIndex, law_4_is_the_sum_of_angles) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    std::vector<Ring> rings(3);
    for (Ring& ring : rings) {
      for (int i = 0; i < 9; ++i) ring.push_back({seeded.uniform(-5, 5), seeded.uniform(-5, 5)});
    }
    const WindingIndex index(rings);
    for (int i = 0; i < 20; ++i) {
      const Point p{seeded.uniform(-5, 5), seeded.uniform(-5, 5)};
      const auto found = index.at(p);
      for (std::uint32_t r = 0; r < 3; ++r)
        EXPECT_EQ(found.contains(r) ? found.at(r) : 0, by_angles(rings[r], p));
    }
  }
}

}  // namespace
}  // namespace thiessen

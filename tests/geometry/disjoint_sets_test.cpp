#include "geometry/disjoint_sets.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

// Beside a list in which each member holds the one that stands for its set.
TEST(DisjointSets, law_1_are_united_as_a_list_that_is_written_anew_each_time) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(200); ++round) {
    const auto count = static_cast<std::uint32_t>(1 + seeded.below(40));
    DisjointSets sets(count);
    std::vector<std::uint32_t> stands(count);
    std::iota(stands.begin(), stands.end(), 0u);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto kept = static_cast<std::uint32_t>(seeded.below(count));
      const auto other = static_cast<std::uint32_t>(seeded.below(count));
      sets.unite(kept, other);
      const std::uint32_t from = stands[other];
      for (std::uint32_t& member : stands) {
        if (member == from) member = stands[kept];
      }
      for (std::uint32_t k = 0; k < count; ++k) ASSERT_EQ(sets.find(k), stands[k]);
    }
  }
}

TEST(DisjointSets, law_2_the_member_that_stood_for_the_kept_set_stands_for_both) {
  DisjointSets sets(5);
  sets.unite(3, 1);
  sets.unite(4, 2);
  sets.unite(1, 2);
  for (const std::uint32_t i : {1u, 2u, 3u, 4u}) EXPECT_EQ(sets.find(i), 3u);
  EXPECT_EQ(sets.find(0), 0u);
  sets.unite(2, 2);
  EXPECT_EQ(sets.find(4), 3u);
}

}  // namespace
}  // namespace thiessen

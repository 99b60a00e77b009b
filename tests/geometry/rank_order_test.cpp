#include "geometry/rank_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

// Entries as numbers are in the order of their ranks, and of their indices among those.
TEST(RankOrder, is_that_of_a_comparison_of_ranks_which_keeps_the_order_of_equals) {
  Seeded seeded;
  for (const std::size_t count : {0u, 1u, 2u, 255u, 256u, 257u, 5000u}) {
    for (const int bits : {1, 8, 10, 11, 20, 32}) {
      std::vector<RankedIndex> entries(count);
      for (std::size_t i = 0; i < count; ++i) {
        const auto rank = static_cast<RankedIndex>(seeded.whole(0, (std::int64_t{1} << bits) - 1));
        entries[i] = rank << ranked_index_bits | i;
      }
      std::vector<RankedIndex> expected = entries;
      std::stable_sort(expected.begin(), expected.end(), [](RankedIndex a, RankedIndex b) {
        return a >> ranked_index_bits < b >> ranked_index_bits;
      });
      std::vector<RankedIndex> spare(count);
      const auto sorted = sorted_by_rank(entries, spare, bits);
      ASSERT_TRUE(std::equal(sorted.begin(), sorted.end(), expected.begin(), expected.end()))
          << count << ' ' << bits;
    }
  }
}

TEST(RankOrder, index_of_an_entry_is_its_low_half) {
  EXPECT_EQ(index_of(RankedIndex{7} << ranked_index_bits | 0xFFFFFFFFu), 0xFFFFFFFFu);
}

}  // namespace
}  // namespace thiessen

#include "rainfall/gaps/cell_weigher.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <set>
#include <thread>
#include <vector>

#include "rainfall/gaps/nine_gauges.h"

namespace thiessen {
namespace {

class CellWeigherTest : public NineGauges {
 protected:
  CellWeigher weigher(bool counts_gauges) const {
    return {weighing_, CellWeigher::Keeping{std::size_t{1} << 20, counts_gauges}, 2};
  }
};

// The second basin has half of the cells at the edges' middles and a quarter of those at corners.
TEST_F(CellWeigherTest, weighs_by_the_parts_of_the_basins_in_the_cells_when_all_report) {
  const std::vector<BasinWeights> basins = weigher(true).full_weights();
  ASSERT_EQ(basins.size(), 2U);
  ASSERT_EQ(basins[0].stations.size(), 1U);
  EXPECT_EQ(basins[0].stations[0].station, StationIndex{4});
  EXPECT_NEAR(basins[0].stations[0].weight, 1, 1e-15);
  ASSERT_EQ(basins[1].stations.size(), 9U);
  for (std::uint32_t s = 0; s < 9; ++s) {
    const double wanted = s == 4 ? 1.0 / 4 : s % 2 == 1 ? 1.0 / 8 : 1.0 / 16;
    EXPECT_EQ(basins[1].stations[s].station, StationIndex{s});
    EXPECT_NEAR(basins[1].stations[s].weight, wanted, 1e-15);
  }
}

TEST_F(CellWeigherTest, has_its_handovers_made_once_for_all_threads) {
  const CellWeigher one = weigher(true);
  std::vector<const Handovers*> found(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i)
    threads.emplace_back([&, i] { found[i] = &one.handovers(); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::set<const Handovers*>(found.begin(), found.end()).size(), 1U);
}

// Where the middle gauge is silent, its cell of 1 goes to its four neighbours alike.
TEST_F(CellWeigherTest, retessellates_and_counts_gauges_where_it_is_to) {
  std::vector<double> readings{0, 4, 0, 8, 100, 12, 0, 16, 0};
  readings[4] = std::numeric_limits<double>::quiet_NaN();
  for (const bool counts : {false, true}) {
    const CellWeigher one = weigher(counts);
    const auto retessellation = one.retessellation();
    EXPECT_TRUE(retessellation->leaves_silent_out());
    const auto values = retessellation->at(readings);
    EXPECT_NEAR(values.at(0).rainfall, (4 + 8 + 12 + 16) / 4.0, 1e-13);
    EXPECT_EQ(values[0].gauges, counts ? 4U : 0U);
  }
}

}  // namespace
}  // namespace thiessen

// What retessellation by handovers gives, beside the tessellation of the gauges that report.
#include "rainfall/gaps/cell_retessellation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

TEST(CellRetessellation, weights_are_those_of_the_cells_of_the_gauges_that_report) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5); ++round) {
    const gappy::Study study = gappy::random_study(seeded);
    const Handovers handovers(study.weighing, 1);
    HandoverCache cache_of_policy(handovers, std::size_t{1} << 20);
    const CellRetessellation policy(handovers, cache_of_policy, {}, true);
    for (const double share : {0.05, 0.4, 0.9}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      const auto expected = study.weighing.weights(reporting_stations(readings), 1);
      const auto found = policy.weights_at(readings);
      ASSERT_EQ(found.size(), expected.size());
      for (std::size_t b = 0; b < expected.size(); ++b) {
        ASSERT_EQ(found[b].stations.size(), expected[b].stations.size());
        for (std::size_t i = 0; i < expected[b].stations.size(); ++i) {
          EXPECT_EQ(found[b].stations[i].station, expected[b].stations[i].station);
          EXPECT_NEAR(found[b].stations[i].weight, expected[b].stations[i].weight, 1e-12);
          EXPECT_NEAR(found[b].stations[i].area, expected[b].stations[i].area, 1e-11);
        }
      }
    }
  }
}

TEST(CellRetessellation, remembering_nothing_changes_no_bit) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  HandoverCache cache_of_remembering(handovers, std::size_t{1} << 20);
  const CellRetessellation remembering(handovers, cache_of_remembering, {}, true);
  HandoverCache cache_of_forgetting(handovers, 0);
  const CellRetessellation forgetting(handovers, cache_of_forgetting, {}, true);
  for (int round = 0; round < 20; ++round) {
    const auto readings = gappy::readings_of(seeded, study, 0.2);
    for (int again = 0; again < 2; ++again) {
      const auto a = remembering.at(readings);
      const auto b = forgetting.at(readings);
      for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].rainfall, b[i].rainfall);
    }
  }
}

// The weights list each station once, whether its cell has ground of its own there, takes some over
// or both, and so tell the number without counting.
TEST(CellRetessellation, gauges_are_as_many_as_have_a_weight) {
  Seeded seeded;
  for (std::uint64_t round = 0; round < Seeded::rounds(5); ++round) {
    const gappy::Study study = gappy::random_study(seeded);
    const CellWeigher weigher(study.weighing, {std::size_t{1} << 20, true}, 1);
    const auto retessellation = weigher.retessellation();
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const std::vector<double> readings = gappy::readings_of(seeded, study, share);
      const auto values = retessellation->at(readings);
      const auto weights = retessellation->weights_at(readings);
      for (std::size_t b = 0; b < values.size(); ++b)
        EXPECT_EQ(values[b].gauges, weights[b].stations.size());
    }
  }
}

TEST(CellRetessellation, counting_no_gauges_changes_no_value) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  HandoverCache cache_of_counting(handovers, std::size_t{1} << 20);
  const CellRetessellation counting(handovers, cache_of_counting, {}, true);
  HandoverCache cache_of_not_counting(handovers, std::size_t{1} << 20);
  const CellRetessellation not_counting(handovers, cache_of_not_counting, {}, false);
  const auto readings = gappy::readings_of(seeded, study, 0.2);
  const auto a = counting.at(readings);
  const auto b = not_counting.at(readings);
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].rainfall, b[i].rainfall);
    EXPECT_GT(a[i].gauges, 0u);
    EXPECT_EQ(b[i].gauges, 0u);
  }
}

TEST(CellRetessellation, silence_of_one_of_two_gauges_at_a_place_leaves_the_cells_as_they_are) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  HandoverCache cache_of_policy(handovers, 0);
  const CellRetessellation policy(handovers, cache_of_policy, {}, true);
  auto readings = gappy::readings_of(seeded, study, 0);
  readings.back() = gappy::silent;  // the twin of 3
  CellAccount account;
  const auto values = policy.at(readings, account);
  EXPECT_TRUE(account.change.empty());
  EXPECT_EQ(account.readings[index(study.network.place_of(StationIndex{3}))], readings[3]);
  readings.back() = readings[3];
  const auto with_twin = policy.at(readings);
  for (std::size_t b = 0; b < values.size(); ++b)
    EXPECT_EQ(values[b].rainfall, with_twin[b].rainfall);
}

}  // namespace
}  // namespace thiessen

// What all policies without a tessellation of their own share: sums over the gauges that report,
// and the network's places for cells.
#include "rainfall/gaps/full_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

/// A policy whose values and weights tell what it was asked.
class Probe : public FullNetwork {
 public:
  using FullNetwork::FullNetwork;
  using FullNetwork::Reporting;
  using FullNetwork::reporting;

 private:
  double value(const Reporting& reporting) const override {
    return reporting.complete ? -1 : static_cast<double>(reporting.gauges);
  }
  BasinWeights weights(const BasinWeights& full, std::span<const double>) const override {
    return {2 * full.area, {}};
  }
  std::vector<CellWeight> change(std::span<const double> readings) const override {
    return {{7, PlaceIndex{3}, readings[0]}};
  }
};

TEST(FullNetwork, law_1_sums_weights_and_readings_over_those_that_report) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    for (const double share : {0.0, 0.3, 0.9, 1.0}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      for (const BasinWeights& full : weigher->full_weights()) {
        long double weight = 0;
        long double sum = 0;
        std::size_t gauges = 0;
        for (const StationWeight& s : full.stations) {
          if (std::isnan(readings[index(s.station)])) continue;
          ++gauges;
          weight += s.weight;
          sum += static_cast<long double>(s.weight) * readings[index(s.station)];
        }
        const Probe::Reporting found = Probe::reporting(full, readings);
        EXPECT_EQ(found.gauges, gauges);
        EXPECT_EQ(found.complete, gauges > 0 && gauges == full.stations.size());
        EXPECT_NEAR(found.share, static_cast<double>(weight), 1e-15);
        EXPECT_NEAR(found.sum, static_cast<double>(sum), 1e-13);
      }
    }
  }
  const Probe::Reporting none = Probe::reporting({1, {}}, std::vector<double>(41, 5));
  EXPECT_FALSE(none.complete);
  EXPECT_EQ(none.gauges, 0u);
}

TEST(FullNetwork, law_2_a_step_has_the_policys_value_and_weights_for_each_basin) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    const Probe policy(*weigher);
    const auto full = weigher->full_weights();
    const auto readings = gappy::readings_of(seeded, study, 0.3);
    CellAccount account;
    const auto values = policy.at(readings);
    const auto again = policy.at(readings, account);
    const auto weights = policy.weights_at(readings);
    ASSERT_EQ(values.size(), full.size());
    ASSERT_EQ(weights.size(), full.size());
    for (std::size_t b = 0; b < full.size(); ++b) {
      const Probe::Reporting of_basin = Probe::reporting(full[b], readings);
      EXPECT_EQ(values[b].gauges, of_basin.gauges);
      EXPECT_EQ(values[b].rainfall, of_basin.complete ? -1 : double(of_basin.gauges));
      EXPECT_EQ(values[b].coverage, 0);
      EXPECT_EQ(again[b].rainfall, values[b].rainfall);
      EXPECT_EQ(weights[b].area, 2 * full[b].area);
    }
    ASSERT_EQ(account.change.size(), 1u);
    EXPECT_EQ(account.change[0].basin, 7u);
    EXPECT_EQ(account.readings.size(), study.network.places().size());
    EXPECT_FALSE(policy.leaves_silent_out());
  }
}

TEST(FullNetwork, law_3_a_cell_has_the_weight_of_all_stations_at_its_place_in_order) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    std::map<std::pair<std::size_t, PlaceIndex>, double> expected;
    const auto full = weigher->full_weights();
    for (std::size_t b = 0; b < full.size(); ++b) {
      for (const StationWeight& s : full[b].stations)
        expected[{b, study.network.place_of(s.station)}] += s.weight;
    }
    auto next = expected.begin();
    for (const CellWeight& cell : Probe(*weigher).full_cells()) {
      ASSERT_NE(next, expected.end());
      EXPECT_EQ(cell.basin, next->first.first);
      EXPECT_EQ(cell.cell, next->first.second);
      EXPECT_NEAR(cell.weight, next->second, 1e-15);
      ++next;
    }
    EXPECT_EQ(next, expected.end());
  }
}

// The last station of a study shares a place with station 3.
TEST(FullNetwork, law_4_a_cell_reads_the_mean_of_its_stations_that_report) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto weigher = std::move(gappy::weighers(study).front());
  const Probe policy(*weigher);
  auto readings = gappy::readings_of(seeded, study, 0);
  readings[3] = 10;
  readings.back() = 20;
  readings[5] = gappy::silent;
  EXPECT_EQ(policy.cell_readings(readings)[3], 15);
  EXPECT_EQ(policy.cell_readings(readings)[4], readings[4]);
  EXPECT_TRUE(std::isnan(policy.cell_readings(readings)[5]));
  readings[3] = gappy::silent;
  EXPECT_EQ(policy.cell_readings(readings)[3], 20);
}

}  // namespace
}  // namespace thiessen

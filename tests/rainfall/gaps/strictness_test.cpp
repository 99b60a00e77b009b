// A strict value is the full network's, or none.
#include "rainfall/gaps/strictness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

TEST(Strictness,
     gives_nothing_where_a_gauge_with_weight_is_silent_and_else_the_full_value_by_a_bit) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    const Strictness policy(*weigher);
    const auto readings = gappy::readings_of(seeded, study, 0);
    const auto full = policy.at(readings);
    for (std::size_t s = 0; s < readings.size(); ++s) {
      auto with_gap = readings;
      with_gap[s] = gappy::silent;
      const auto values = policy.at(with_gap);
      for (std::size_t b = 0; b < values.size(); ++b) {
        const auto& stations = policy.full_weights()[b].stations;
        const bool weighs =
            std::any_of(stations.begin(), stations.end(),
                        [&](const StationWeight& w) { return index(w.station) == s; });
        EXPECT_EQ(std::isnan(values[b].rainfall), weighs);
        EXPECT_EQ(values[b].gauges, stations.size() - (weighs ? 1 : 0));
        if (!weighs) {
          EXPECT_EQ(values[b].rainfall, full[b].rainfall);
        }
      }
    }
  }
}

TEST(Strictness, changes_no_weight) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    const Strictness policy(*weigher);
    const auto readings = gappy::readings_of(seeded, study, 0.01);
    CellAccount account;
    policy.at(readings, account);
    EXPECT_TRUE(account.change.empty());
    const auto weights = policy.weights_at(readings);
    for (std::size_t b = 0; b < weights.size(); ++b) {
      const BasinWeights& full = policy.full_weights()[b];
      EXPECT_EQ(weights[b].area, full.area);
      if (weights[b].stations.empty()) continue;
      ASSERT_EQ(weights[b].stations.size(), full.stations.size());
      for (std::size_t i = 0; i < full.stations.size(); ++i)
        EXPECT_EQ(weights[b].stations[i].weight, full.stations[i].weight);
    }
  }
}

}  // namespace
}  // namespace thiessen

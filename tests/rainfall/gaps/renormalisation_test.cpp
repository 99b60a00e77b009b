// Renormalised values beside the full network's weights, renormalised by hand.
#include "rainfall/gaps/renormalisation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

TEST(Renormalisation, is_the_full_networks_weights_divided_by_what_reports) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    const Renormalisation policy(*weigher);
    const auto full = weigher->full_weights();
    for (const double share : {0.05, 0.3, 0.9}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      const auto values = policy.at(readings);
      for (std::size_t b = 0; b < values.size(); ++b) {
        long double sum = 0;
        long double reporting = 0;
        std::size_t gauges = 0;
        for (const StationWeight& s : full[b].stations) {
          if (std::isnan(readings[index(s.station)])) continue;
          ++gauges;
          reporting += s.weight;
          sum += static_cast<long double>(s.weight) * readings[index(s.station)];
        }
        EXPECT_EQ(values[b].gauges, gauges);
        EXPECT_EQ(std::isnan(values[b].rainfall), gauges == 0);
        if (gauges > 0) {
          EXPECT_NEAR(values[b].rainfall, static_cast<double>(sum / reporting), 1e-12);
        }
      }
    }
  }
}

TEST(Renormalisation, keeps_the_ratio_of_any_two_weights) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  for (const auto& weigher : gappy::weighers(study)) {
    const Renormalisation policy(*weigher);
    const auto readings = gappy::readings_of(seeded, study, 0.4);
    const auto weights = policy.weights_at(readings);
    for (std::size_t b = 0; b < weights.size(); ++b) {
      std::size_t next = 0;
      double scale = 0;
      for (const StationWeight& s : policy.full_weights()[b].stations) {
        if (std::isnan(readings[index(s.station)])) continue;
        ASSERT_LT(next, weights[b].stations.size());
        const StationWeight& scaled = weights[b].stations[next++];
        EXPECT_EQ(scaled.station, s.station);
        if (scale == 0) scale = scaled.weight / s.weight;
        EXPECT_NEAR(scaled.weight / s.weight, scale, 1e-14 * scale);
        EXPECT_GE(scale, 1);
      }
      EXPECT_EQ(next, weights[b].stations.size());
    }
  }
}

// Halves of 0.25 and 0.25, and 0.5: two stations at (0, 0), one at (4, 0).
TEST(Renormalisation, of_a_place_whose_stations_report_in_part_counts_the_share_of_those_that_do) {
  const gappy::Study study({{"a", {0, 0}, 2}, {"b", {4, 0}, 3}, {"c", {0, 0}, 4}},
                           {shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})});
  const CellWeigher cells(study.weighing, {0, true}, 1);
  const Renormalisation policy(cells);
  EXPECT_EQ(policy.at(std::vector<double>{10, 40, gappy::silent})[0].rainfall,
            (0.25 * 10 + 0.5 * 40) / 0.75);
  CellAccount account;
  policy.at(std::vector<double>{10, 40, gappy::silent}, account);
  ASSERT_EQ(account.change.size(), 1u);
  EXPECT_EQ(account.change[0].cell, PlaceIndex{0});
  EXPECT_EQ(account.change[0].weight, -0.25);
  EXPECT_EQ(account.readings, (std::vector<double>{10, 40}));
}

}  // namespace
}  // namespace thiessen

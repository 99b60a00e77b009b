// The laws that every gap policy keeps, with the cells and with other methods.
#include "rainfall/gaps/gap_policies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

constexpr double accuracy = 1e-10;  // of readings up to 100

using Check = std::function<void(const GapPolicy& policy, const gappy::Study& study)>;

/// Calls `check` with every policy of every weigher of a study.
void with_all(const gappy::Study& study, const Check& check) {
  for (const auto& weigher : gappy::weighers(study)) {
    for (const Gaps gaps : all_gaps) {
      SCOPED_TRACE(name_of(gaps));
      check(*gap_policy(gaps, *weigher), study);
    }
  }
}

double sum_of(const BasinWeights& weights, std::span<const double> readings) {
  double sum = 0;
  for (const StationWeight& s : weights.stations) sum += s.weight * readings[index(s.station)];
  return sum;
}

TEST(GapPolicies, law_1_each_has_a_name_of_its_own) {
  std::set<std::string> names;
  for (const Gaps gaps : all_gaps) names.insert(name_of(gaps));
  EXPECT_EQ(names, (std::set<std::string>{"renormalise", "retessellate", "strict"}));
  EXPECT_EQ(names.size(), all_gaps.size());
}

TEST(GapPolicies, law_2_without_gaps_all_give_the_full_networks_value) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto readings = gappy::readings_of(seeded, study, 0);
  with_all(study, [&](const GapPolicy& policy, const gappy::Study&) {
    const auto values = policy.at(readings);
    const auto weights = policy.weights_at(readings);
    for (std::size_t b = 0; b < values.size(); ++b) {
      const BasinWeights& full = policy.full_weights()[b];
      EXPECT_EQ(std::isnan(values[b].rainfall), full.stations.empty());
      if (!full.stations.empty()) {
        EXPECT_NEAR(values[b].rainfall, sum_of(full, readings), accuracy);
      }
      EXPECT_EQ(values[b].gauges, full.stations.size());
      ASSERT_EQ(weights[b].stations.size(), full.stations.size());
      for (std::size_t i = 0; i < full.stations.size(); ++i) {
        EXPECT_EQ(weights[b].stations[i].station, full.stations[i].station);
        EXPECT_NEAR(weights[b].stations[i].weight, full.stations[i].weight, 1e-14);
      }
    }
  });
}

TEST(GapPolicies, law_3_a_value_is_the_sum_of_weights_times_readings_and_weights_add_up_to_1) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  with_all(study, [&](const GapPolicy& policy, const gappy::Study&) {
    for (const double share : {0.0, 0.02, 0.3, 0.9}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      const auto values = policy.at(readings);
      const auto weights = policy.weights_at(readings);
      for (std::size_t b = 0; b < values.size(); ++b) {
        EXPECT_EQ(std::isnan(values[b].rainfall), weights[b].stations.empty());
        if (std::isnan(values[b].rainfall)) continue;
        EXPECT_NEAR(values[b].rainfall, sum_of(weights[b], readings), accuracy);
        EXPECT_EQ(values[b].gauges, weights[b].stations.size());
        double whole = 0;
        for (const StationWeight& s : weights[b].stations) whole += s.weight;
        EXPECT_NEAR(whole, 1, 1e-12);
      }
    }
  });
}

TEST(GapPolicies, law_4_a_value_is_made_of_its_account) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  with_all(study, [&](const GapPolicy& policy, const gappy::Study&) {
    for (const double share : {0.0, 0.02, 0.3, 0.9}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      CellAccount account;
      const auto values = policy.at(readings, account);
      EXPECT_EQ(policy.at(readings).size(), values.size());
      std::vector<CellWeight> weights = policy.full_cells();
      weights.insert(weights.end(), account.change.begin(), account.change.end());
      // A cell that is silent weighs nothing in the end, and has no reading.
      std::vector<std::vector<double>> of_cell(values.size(),
                                               std::vector<double>(account.readings.size(), 0));
      for (const CellWeight& w : weights) of_cell[w.basin][index(w.cell)] += w.weight;
      for (std::size_t b = 0; b < values.size(); ++b) {
        if (std::isnan(values[b].rainfall)) continue;
        double sum = 0;
        double whole = 0;
        for (std::size_t cell = 0; cell < account.readings.size(); ++cell) {
          const double weight = of_cell[b][cell];
          whole += weight;
          if (std::abs(weight) > 1e-15) sum += weight * account.readings[cell];
        }
        EXPECT_NEAR(sum / whole, values[b].rainfall, accuracy);
      }
    }
  });
}

// Multiplying by a power of two is exact.
TEST(GapPolicies, law_5_values_are_in_the_readings_unit) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto readings = gappy::readings_of(seeded, study, 0.2);
  auto fourfold = readings;
  for (double& reading : fourfold) reading *= 4;
  with_all(study, [&](const GapPolicy& policy, const gappy::Study&) {
    const auto values = policy.at(readings);
    const auto other = policy.at(fourfold);
    for (std::size_t b = 0; b < values.size(); ++b) {
      EXPECT_EQ(std::isnan(values[b].rainfall), std::isnan(other[b].rainfall));
      if (!std::isnan(values[b].rainfall)) {
        EXPECT_EQ(other[b].rainfall, 4 * values[b].rainfall);
      }
    }
  });
}

TEST(GapPolicies, law_6_where_no_gauge_reports_there_is_no_value) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto readings = gappy::readings_of(seeded, study, 1.1);
  with_all(study, [&](const GapPolicy& policy, const gappy::Study&) {
    for (const BasinRainfall& value : policy.at(readings)) {
      EXPECT_TRUE(std::isnan(value.rainfall));
      EXPECT_EQ(value.gauges, 0u);
    }
    for (const BasinWeights& basin : policy.weights_at(readings))
      EXPECT_TRUE(basin.stations.empty());
    for (const double reading : policy.cell_readings(readings)) EXPECT_TRUE(std::isnan(reading));
  });
}

/// Whether two steps' values differ at any basin by more than idw's accuracy, 1e-7 of a weight.
bool differ(const std::vector<BasinRainfall>& a, const std::vector<BasinRainfall>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i].rainfall) != std::isnan(b[i].rainfall)) return true;
    if (std::abs(a[i].rainfall - b[i].rainfall) > 1e-5) return true;
  }
  return false;
}

TEST(GapPolicies, law_7_those_that_leave_the_silent_out_give_what_a_network_without_them_gives) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto all = gappy::weighers(study);
  std::vector<std::size_t> differences(all_gaps.size() * all.size(), 0);
  for (int round = 0; round < 5; ++round) {
    const auto readings = gappy::readings_of(seeded, study, 0.3);
    const gappy::Study rest = study.without_silent(readings);
    const auto of_rest = gappy::weighers(rest);
    for (std::size_t g = 0; g < all_gaps.size(); ++g) {
      for (std::size_t w = 0; w < all.size(); ++w) {
        const auto found = gap_policy(all_gaps[g], *all[w])->at(readings);
        const auto expected = gap_policy(all_gaps[g], *of_rest[w])->at(gappy::reported(readings));
        if (differ(found, expected)) ++differences[g * all.size() + w];
      }
    }
  }
  for (std::size_t g = 0; g < all_gaps.size(); ++g) {
    for (std::size_t w = 0; w < all.size(); ++w) {
      const bool leaves_out = gap_policy(all_gaps[g], *all[w])->leaves_silent_out();
      // The mean of the gauges inside is renormalised by leaving out, too: all weights are equal.
      const bool is_mean_of_inside = w == 1 && all_gaps[g] == Gaps::renormalise;
      if (is_mean_of_inside) continue;
      EXPECT_EQ(differences[g * all.size() + w] == 0, leaves_out) << name_of(all_gaps[g]) << w;
    }
  }
}

}  // namespace
}  // namespace thiessen

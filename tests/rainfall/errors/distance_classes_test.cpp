#include "rainfall/errors/distance_classes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

using Table = std::vector<std::vector<double>>;  // by step

StepSample sample_of(const Table& table, std::size_t sites) {
  StepSample sample(sites, std::max<std::size_t>(2, table.size()));
  for (const auto& readings : table) sample.add(readings);
  return sample;
}

Sites on_a_line(std::size_t count) {
  std::vector<Point> places;
  for (std::size_t i = 0; i < count; ++i) places.push_back({std::pow(2.0, i), 0});
  return Sites(places, Metric::planar);
}

Table random_table(Seeded& seeded, std::size_t steps, std::size_t sites) {
  Table table(steps, std::vector<double>(sites));
  for (auto& readings : table) {
    const double common = seeded.uniform(0, 10);
    for (double& r : readings) r = common + seeded.uniform(0, 10);
  }
  return table;
}

double correlation(const Table& table, std::size_t a, std::size_t b) {
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  for (const auto& r : table) {
    sa += r[a];
    sb += r[b];
    saa += r[a] * r[a];
    sbb += r[b] * r[b];
    sab += r[a] * r[b];
  }
  const auto n = static_cast<double>(table.size());
  return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

// Law: where all report, one less the correlation. Of 5 gauges at 1, 2, 4, 8 and 16 the pairs that
// are a distance of 1 and one of 15 apart are alone in their classes.
TEST(DistanceClasses, tell_one_less_the_correlation) {
  Seeded seeded;
  const Table table = random_table(seeded, 200, 5);
  const DistanceClasses found = distance_classes(sample_of(table, 5), on_a_line(5), 1);
  ASSERT_EQ(found.shortfall, "");
  const Sites sites = on_a_line(5);
  const auto gauge = [&](std::size_t place) { return sites.of_place(place); };
  const DistanceClass& nearest = found.classes.front();
  EXPECT_EQ(nearest.distance, 1);
  EXPECT_EQ(nearest.pairs, 1);
  EXPECT_NEAR(nearest.semivariance, 1 - correlation(table, gauge(0), gauge(1)), 1e-5);
  double pairs = 0;
  for (const DistanceClass& c : found.classes) pairs += c.pairs;
  EXPECT_EQ(pairs, 10);
}

// A gauge that reads three times as much, and more always, differs no more.
TEST(DistanceClasses, do_not_know_units_nor_what_lasts) {
  Seeded seeded;
  Table table = random_table(seeded, 50, 6);
  const auto first = distance_classes(sample_of(table, 6), on_a_line(6), 1);
  for (auto& readings : table) readings[2] = 3 * readings[2] + 40;
  const auto second = distance_classes(sample_of(table, 6), on_a_line(6), 2);
  ASSERT_EQ(first.classes.size(), second.classes.size());
  for (std::size_t i = 0; i < first.classes.size(); ++i)
    EXPECT_NEAR(first.classes[i].semivariance, second.classes[i].semivariance, 1e-5);
}

TEST(DistanceClasses, pass_over_steps_at_which_one_is_silent) {
  Seeded seeded;
  Table table = random_table(seeded, 100, 5);
  Table common;
  for (std::size_t t = 0; t < table.size(); ++t) {
    if (t % 3 == 0) {
      table[t] = std::vector<double>(5, silent);
    } else {
      common.push_back(table[t]);
    }
  }
  const auto whole = distance_classes(sample_of(common, 5), on_a_line(5), 1);
  const auto gaps = distance_classes(sample_of(table, 5), on_a_line(5), 1);
  for (std::size_t i = 0; i < whole.classes.size(); ++i)
    EXPECT_NEAR(whole.classes[i].semivariance, gaps.classes[i].semivariance, 1e-5);
}

TEST(DistanceClasses, of_many_gauges_reach_over_all_distances_at_a_bounded_cost) {
  Seeded seeded;
  std::vector<Point> places;
  for (int i = 0; i < 3'000; ++i) places.push_back({seeded.uniform(0, 1), seeded.uniform(0, 1)});
  const auto found = distance_classes(sample_of(random_table(seeded, 10, 3'000), 3'000),
                                      Sites(places, Metric::planar), 1);
  double pairs = 0;
  for (const DistanceClass& c : found.classes) pairs += c.pairs;
  EXPECT_LE(pairs, 20'000);
  EXPECT_GE(pairs, 15'000);
  EXPECT_LT(found.classes.front().distance, 0.01);
  EXPECT_GT(found.classes.back().distance, 1);
}

TEST(DistanceClasses, say_what_is_missing) {
  Seeded seeded;
  const auto shortfall = [&](const Table& table, std::size_t sites) {
    const auto found = distance_classes(sample_of(table, sites), on_a_line(sites), 1);
    EXPECT_TRUE(found.classes.empty());
    return found.shortfall;
  };
  EXPECT_EQ(shortfall(random_table(seeded, 9, 6), 6),
            "9 time steps cannot tell how gauges differ with distance: 10 are needed");
  EXPECT_EQ(shortfall({}, 6),
            "0 time steps cannot tell how gauges differ with distance: 10 are needed");
  EXPECT_EQ(shortfall(random_table(seeded, 50, 4), 4),
            "of 4 places with gauges 4 have 10 readings that are not all the same: 5 are needed");
  EXPECT_EQ(shortfall(random_table(seeded, 50, 1), 1),
            "of 1 place with gauges 1 has 10 readings that are not all the same: 5 are needed");
  EXPECT_EQ(shortfall(Table(20, std::vector<double>(7, 3.25)), 7),
            "of 7 places with gauges 0 have 10 readings that are not all the same: 5 are needed");
  Table alike;
  for (int t = 0; t < 20; ++t) alike.emplace_back(6, t * 0.7);
  EXPECT_EQ(shortfall(alike, 6), "all gauges read alike at all steps");
  Table never_together = random_table(seeded, 60, 6);
  for (std::size_t t = 0; t < 60; ++t) {
    for (std::size_t s = 0; s < 6; ++s) {
      if (t % 6 != s) never_together[t][s] = silent;
    }
  }
  EXPECT_EQ(shortfall(never_together, 6),
            "0 pairs of gauges share 10 steps at which both report: 10 are needed");
}

// By hand: places at 0, 1 and 4 on a line with values 2, 5 and 5. Pairs at 1 (half of 9), at 3 (0)
// and at 4 (half of 9); 3 and 4 are two classes.
TEST(DistanceClasses, of_one_value_a_place) {
  const std::vector<Point> places = {{0, 0}, {1, 0}, {4, 0}};
  const Sites sites(places, Metric::planar);
  std::vector<double> values(3);
  for (std::size_t place = 0; place < 3; ++place)
    values[sites.of_place(place)] = std::array{2.0, 5.0, 5.0}[place];
  const std::vector<DistanceClass> classes = distance_classes(values, sites);
  double pairs = 0;
  for (const DistanceClass& c : classes) {
    pairs += c.pairs;
    EXPECT_NEAR(c.semivariance, std::abs(c.distance - 3) < 0.4 ? 0 : 4.5, 1e-12) << c.distance;
  }
  EXPECT_EQ(pairs, 3);
}

}  // namespace
}  // namespace thiessen

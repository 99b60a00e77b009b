#include "rainfall/areal_rainfall.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "basin/shapes.h"
#include "geometry/seeded.h"
#include "rainfall/textbook.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();
constexpr Yardstick plane{Metric::planar, 1, 0.1};

class TextbookRainfall : public testing::Test {
 protected:
  BasinRainfall rainfall(Gaps gaps, const std::vector<double>& readings,
                         std::size_t min_gauges = 1) {
    return ArealRainfall(weighing_, {gaps, min_gauges}, 1).at(readings).at(0);
  }
  static std::vector<double> with_silent(std::vector<std::size_t> gauges) {
    std::vector<double> readings = textbook::readings();
    for (const std::size_t gauge : gauges) readings.at(gauge - 1) = silent;
    return readings;
  }

  const Network network_{textbook::stations(), Metric::planar};
  const std::vector<Basin> basins_{textbook::basin()};
  const Weighing weighing_{network_, basins_, plane};
};

TEST_F(TextbookRainfall, is_its_fraction_whatever_the_policy) {
  for (const Gaps gaps : {Gaps::retessellate, Gaps::renormalise, Gaps::strict}) {
    const BasinRainfall r = rainfall(gaps, textbook::readings());
    EXPECT_NEAR(r.rainfall, 119463938.0 / 1710625, 1e-13);
    EXPECT_EQ(r.gauges, 6u);
    EXPECT_EQ(r.coverage, 1);
  }
}

TEST_F(TextbookRainfall, with_gauge_5_silent) {
  const std::vector<double> readings = with_silent({5});
  const double reporting = 1 - 2563.0 / 11200;
  const BasinRainfall again = rainfall(Gaps::retessellate, readings);
  EXPECT_NEAR(again.rainfall, 64.095794, 5e-7);
  EXPECT_NEAR(again.coverage, reporting, 1e-15);
  const BasinRainfall scaled = rainfall(Gaps::renormalise, readings);
  EXPECT_NEAR(scaled.rainfall, 59.401758, 5e-7);
  EXPECT_NEAR(scaled.rainfall, (119463938.0 / 1710625 - 105 * 2563.0 / 11200) / reporting, 1e-13);
  EXPECT_EQ(scaled.gauges, 5u);
  EXPECT_NEAR(scaled.coverage, reporting, 1e-15);
  const BasinRainfall none = rainfall(Gaps::strict, readings);
  EXPECT_TRUE(std::isnan(none.rainfall));
  EXPECT_EQ(none.gauges, 5u);
  EXPECT_NEAR(none.coverage, reporting, 1e-15);
}

// Gauges 1, 4 and 6 have no weight: with gauge 1 silent a strict value stands.
TEST_F(TextbookRainfall, does_not_miss_a_gauge_without_weight) {
  const std::vector<double> readings = with_silent({1, 4, 6});
  for (const Gaps gaps : {Gaps::renormalise, Gaps::strict}) {
    const BasinRainfall r = rainfall(gaps, readings);
    EXPECT_NEAR(r.rainfall, 119463938.0 / 1710625, 1e-13);
    EXPECT_EQ(r.coverage, 1);
  }
}

TEST_F(TextbookRainfall, with_every_gauge_silent_is_none) {
  for (const Gaps gaps : {Gaps::retessellate, Gaps::renormalise, Gaps::strict}) {
    const BasinRainfall r = rainfall(gaps, std::vector<double>(9, silent));
    EXPECT_TRUE(std::isnan(r.rainfall));
    EXPECT_EQ(r.gauges, 0u);
    EXPECT_EQ(r.coverage, 0);
  }
}

TEST_F(TextbookRainfall, with_one_gauge_reporting_is_its_reading_where_the_policy_allows) {
  const std::vector<double> readings = with_silent({2, 3, 4, 5, 6, 7, 8, 9});
  const BasinRainfall again = rainfall(Gaps::retessellate, readings);
  EXPECT_EQ(again.rainfall, 62);
  EXPECT_EQ(again.gauges, 1u);
  EXPECT_EQ(again.coverage, 0);  // gauge 1 has none of the basin in the full network
  EXPECT_TRUE(std::isnan(rainfall(Gaps::renormalise, readings).rainfall));
}

TEST_F(TextbookRainfall, is_left_empty_below_the_least_number_of_gauges) {
  EXPECT_FALSE(std::isnan(rainfall(Gaps::retessellate, textbook::readings(), 6).rainfall));
  EXPECT_TRUE(std::isnan(rainfall(Gaps::retessellate, textbook::readings(), 7).rainfall));
  const std::vector<double> readings = with_silent({5});
  EXPECT_FALSE(std::isnan(rainfall(Gaps::renormalise, readings, 5).rainfall));
  EXPECT_TRUE(std::isnan(rainfall(Gaps::renormalise, readings, 6).rainfall));
}

// Two stations at (0, 0), one at (4, 0), and a basin that both places halve.
TEST(SharedPlace, partly_silent_goes_by_the_policy) {
  const Network network({{"a", {0, 0}, 2}, {"b", {4, 0}, 3}, {"c", {0, 0}, 4}}, Metric::planar);
  const std::vector<Basin> basins{shapes::basin({{shapes::rectangle({-1, -1}, {5, 1}), {}}})};
  const Weighing weighing(network, basins, plane);
  const std::vector<double> readings{10, 40, silent};
  const auto at = [&](Gaps gaps) { return ArealRainfall(weighing, {gaps}, 1).at(readings)[0]; };
  EXPECT_EQ(at(Gaps::retessellate).rainfall, 25);  // half of it all a's
  EXPECT_EQ(at(Gaps::retessellate).gauges, 2u);
  EXPECT_EQ(at(Gaps::retessellate).coverage, 0.75);
  EXPECT_EQ(at(Gaps::renormalise).rainfall, (0.25 * 10 + 0.5 * 40) / 0.75);
  EXPECT_TRUE(std::isnan(at(Gaps::strict).rainfall));
}

std::vector<std::vector<double>> gappy_steps(Seeded& seeded, std::size_t stations,
                                             std::size_t steps) {
  std::vector<std::vector<double>> all(steps, std::vector<double>(stations));
  for (auto& readings : all) {
    const auto pattern = seeded.below(7);
    for (std::size_t s = 0; s < stations; ++s) {
      const double value = seeded.uniform(0, 100);
      readings[s] = (s * 7 + pattern) % 5 == 0 ? silent : value;
    }
  }
  return all;
}

void expect_same(const std::vector<BasinRainfall>& a, const std::vector<BasinRainfall>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(std::isnan(a[i].rainfall), std::isnan(b[i].rainfall));
    if (!std::isnan(a[i].rainfall)) {
      ASSERT_EQ(a[i].rainfall, b[i].rainfall);
    }
    ASSERT_EQ(a[i].gauges, b[i].gauges);
    ASSERT_EQ(a[i].coverage, b[i].coverage);
  }
}

class RandomRainfall : public testing::Test {
 protected:
  RandomRainfall() {
    std::vector<Station> stations;
    for (int i = 0; i < 60; ++i)
      stations.push_back({std::to_string(i), {seeded_.uniform(0, 5), seeded_.uniform(0, 5)}, 0});
    stations.push_back({"twin", stations[3].position, 0});
    network_.emplace(stations, Metric::planar);
    for (int i = 0; i < 6; ++i) {
      const Point centre{seeded_.uniform(0, 5), seeded_.uniform(0, 5)};
      basins_.push_back(shapes::basin({{shapes::star(seeded_, centre, 1.5, 20), {}}}));
    }
  }

  Seeded seeded_;
  std::optional<Network> network_;
  std::vector<Basin> basins_;
};

TEST_F(RandomRainfall, from_remembered_weights_is_that_from_scratch_by_a_bit) {
  const Weighing weighing(*network_, basins_, plane);
  const ArealRainfall remembering(weighing, {}, 1);
  const ArealRainfall forgetting(weighing, {Gaps::retessellate, 1, true, 0}, 1);
  for (const auto& readings : gappy_steps(seeded_, 61, 100))
    expect_same(remembering.at(readings), forgetting.at(readings));
}

// A silent gauge's station might as well not stand in the file.
TEST_F(RandomRainfall, retessellated_is_that_of_the_network_without_its_silent_gauges) {
  const Weighing weighing(*network_, basins_, plane);
  const ArealRainfall whole(weighing, {}, 1);
  for (const auto& readings : gappy_steps(seeded_, 61, 10)) {
    std::vector<Station> stations;
    std::vector<double> values;
    for (std::size_t s = 0; s < readings.size(); ++s) {
      if (std::isnan(readings[s])) continue;
      stations.push_back(network_->stations()[s]);
      values.push_back(readings[s]);
    }
    const Network network(stations, Metric::planar);
    const Weighing smaller(network, basins_, plane);
    const auto expected = ArealRainfall(smaller, {}, 1).at(values);
    const auto found = whole.at(readings);
    for (std::size_t b = 0; b < expected.size(); ++b) {
      EXPECT_NEAR(found[b].rainfall, expected[b].rainfall, 1e-11);
      EXPECT_EQ(found[b].gauges, expected[b].gauges);
    }
  }
}

// What --weights-log writes is enough to have any value again by hand.
TEST_F(RandomRainfall, is_the_sum_of_readings_with_the_weights_that_are_told) {
  const Weighing weighing(*network_, basins_, plane);
  for (const Gaps gaps : {Gaps::retessellate, Gaps::renormalise, Gaps::strict}) {
    const ArealRainfall rainfall(weighing, {gaps, 3}, 1);
    for (const auto& readings : gappy_steps(seeded_, 61, 30)) {
      const auto values = rainfall.at(readings);
      const auto weights = rainfall.weights_at(readings);
      for (std::size_t b = 0; b < values.size(); ++b) {
        if (std::isnan(values[b].rainfall)) {
          EXPECT_TRUE(weights[b].stations.empty());
          continue;
        }
        EXPECT_EQ(weights[b].stations.size(), values[b].gauges);
        double sum = 0;
        double whole = 0;
        for (const StationWeight& s : weights[b].stations) {
          sum += s.weight * readings[index(s.station)];
          whole += s.weight;
        }
        EXPECT_NEAR(sum, values[b].rainfall, 1e-11);
        EXPECT_NEAR(whole, 1, 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace thiessen

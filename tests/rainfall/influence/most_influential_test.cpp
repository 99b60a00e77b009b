// Which gauge's leaving changes a basin's rainfall most.
#include "rainfall/influence/most_influential.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rainfall/gaps/gappy_study.h"
#include "rainfall/influence/influence.h"

namespace thiessen {
namespace {

StepSample sample_of(const std::vector<std::vector<double>>& steps) {
  StepSample sample(steps.front().size(), steps.size() + 1);
  for (const auto& step : steps) sample.add(step);
  return sample;
}

TEST(MostInfluential, law_1_where_all_steps_are_looked_at_no_gauges_influence_is_larger) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  std::vector<std::vector<double>> steps;
  for (int i = 0; i < 30; ++i) steps.push_back(gappy::readings_of(seeded, study, 0.1));
  const SampledInfluence found = most_influential(handovers, sample_of(steps), 1, 1);
  EXPECT_EQ(found.steps, 30u);
  Influence influence(handovers, std::size_t{1} << 20, 1);
  std::vector<std::span<const double>> rows(steps.begin(), steps.end());
  influence.add(rows);
  const auto all = influence.result();
  ASSERT_EQ(found.gauges.size(), all.size());
  for (std::size_t b = 0; b < all.size(); ++b) {
    bool is_there = false;
    for (const GaugeInfluence& gauge : all[b]) {
      EXPECT_FALSE(gauge.rms_change > found.gauges[b].rms_change);
      is_there = is_there || (gauge.station == found.gauges[b].station &&
                              gauge.rms_change == found.gauges[b].rms_change);
    }
    EXPECT_TRUE(is_there);
  }
}

TEST(MostInfluential, law_2_it_says_how_many_steps_it_looks_at) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  std::vector<std::vector<double>> steps;
  for (int i = 0; i < 60; ++i) steps.push_back(gappy::readings_of(seeded, study, 0.3));
  const StepSample sample = sample_of(steps);
  EXPECT_EQ(most_influential(handovers, sample, 1, 1).steps, 60u);
  EXPECT_EQ(most_influential(handovers, sample, 7, 1).steps, 9u);
  EXPECT_EQ(most_influential(handovers, sample, 60, 1).steps, 1u);
}

TEST(MostInfluential, law_3_where_all_readings_are_the_same_no_gauge_is) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers handovers(study.weighing, 1);
  const std::vector<double> same(study.network.stations().size(), 7);
  for (const MostInfluential& gauge :
       most_influential(handovers, sample_of({same, same, same}), 1, 1).gauges)
    EXPECT_EQ(gauge.rms_change, 0);
}

}  // namespace
}  // namespace thiessen

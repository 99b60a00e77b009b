// What is the same with every gap policy.
#include "rainfall/weighed_rainfall.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rainfall/areal_rainfall.h"
#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

TEST(WeighedRainfall, coverage_is_what_the_full_network_gives_to_those_that_report) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto readings = gappy::readings_of(seeded, study, 0.3);
  for (const Gaps gaps : all_gaps) {
    const ArealRainfall rainfall(study.weighing, {gaps}, 1);
    const auto values = rainfall.at(readings);
    for (std::size_t b = 0; b < values.size(); ++b) {
      double reporting = 0;
      for (const StationWeight& s : rainfall.full_weights()[b].stations) {
        if (!std::isnan(readings[index(s.station)])) reporting += s.weight;
      }
      EXPECT_NEAR(values[b].coverage, reporting, 1e-14);
    }
  }
}

TEST(WeighedRainfall, has_a_value_where_the_policy_has_and_enough_gauges_weigh) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const auto readings = gappy::readings_of(seeded, study, 0.05);
  for (const Gaps gaps : all_gaps) {
    const auto all = ArealRainfall(study.weighing, {gaps}, 1).at(readings);
    for (const bool accounts : {true, false}) {
      for (const std::size_t least : {2u, 10u, 14u, 40u}) {
        const ArealRainfall rainfall(study.weighing, {gaps, least, accounts}, 1);
        const auto values = rainfall.at(readings);
        const auto weights = rainfall.weights_at(readings);
        for (std::size_t b = 0; b < values.size(); ++b) {
          const bool has_value = !std::isnan(all[b].rainfall) && all[b].gauges >= least;
          EXPECT_EQ(!std::isnan(values[b].rainfall), has_value);
          EXPECT_EQ(!weights[b].stations.empty(), has_value);
        }
      }
    }
  }
}

TEST(WeighedRainfall, that_wants_several_gauges_is_not_that_of_a_network_without_the_silent) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  EXPECT_TRUE(ArealRainfall(study.weighing, {Gaps::retessellate, 1}, 1).leaves_silent_out());
  EXPECT_FALSE(ArealRainfall(study.weighing, {Gaps::retessellate, 2}, 1).leaves_silent_out());
  EXPECT_FALSE(ArealRainfall(study.weighing, {Gaps::strict, 1}, 1).leaves_silent_out());
}

TEST(ArealRainfall, has_the_same_handovers_whatever_its_policy) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Handovers expected(study.weighing, 1);
  for (const Gaps gaps : all_gaps) {
    const ArealRainfall rainfall(study.weighing, {gaps}, 1);
    const Handovers& found = rainfall.handovers();
    EXPECT_EQ(&found, &rainfall.handovers());
    ASSERT_EQ(found.full().size(), expected.full().size());
    for (std::size_t i = 0; i < expected.full().size(); ++i)
      EXPECT_EQ(found.full()[i].weight, expected.full()[i].weight);
  }
}

}  // namespace
}  // namespace thiessen

#include "study/weight_findings.h"

#include <gtest/gtest.h>

#include <memory>

namespace thiessen {
namespace {

/// A square from (0, 0) to (4, 2) beside one from (10, 0) to (12, 2).
std::shared_ptr<StudyParts> two_basins(std::vector<Station> stations) {
  auto parts = std::make_shared<StudyParts>();
  parts->stations = std::move(stations);
  parts->basins = {{"near", {{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {}}}, {}},
                   {"far", {{{{10, 0}, {12, 0}, {12, 2}, {10, 2}}, {}}}, {}}};
  parts->metres_per_unit = 1;
  return parts;
}

TEST(WeightFindings, tells_basins_without_a_gauge_and_gauges_that_weigh_nowhere) {
  Warnings warnings;
  const Study study(two_basins({{"a", {1, 1}}, {"b", {3, 1}}, {"c", {-50, 1}}}), {}, warnings);
  const WeightFindings findings =
      findings_of(study, study.weighing().weights(study.all_report(), 1));
  EXPECT_EQ(findings.basins_without_gauge, 1U);
  EXPECT_EQ(findings.idle_gauges, 1U);
  EXPECT_EQ(findings.basins[0].gauges_inside, 2U);
  EXPECT_EQ(findings.basins[0].largest_weight, 0.5);
  EXPECT_TRUE(findings.basins[0].adds_up());
  EXPECT_EQ(findings.basins[1].largest_weight, 1);
  EXPECT_TRUE(findings.basins[1].adds_up());
}

TEST(WeightFindings, weights_that_do_not_add_up_are_told) {
  Warnings warnings;
  const Study study(two_basins({{"a", {1, 1}}}), {}, warnings);
  const WeightFindings findings = findings_of(study, {{8, {{StationIndex{0}, 8, 0.999}}}, {4, {}}});
  EXPECT_FALSE(findings.basins[0].adds_up());
  EXPECT_FALSE(findings.basins[1].adds_up());
}

}  // namespace
}  // namespace thiessen

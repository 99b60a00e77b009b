#include "rainfall/methods/method_weigher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "rainfall/methods/method_study.h"

namespace thiessen {
namespace {

using namespace by_method;

/// All places that report weigh in the first basin in proportion to their number from 1; in the
/// second basin none does.
class ByNumber : public AreaMethod {
 public:
  Weights weights(const ReportingPlaces& reports, const NormalMonth&) const override {
    Weights weights(2);
    double sum = 0;
    for (std::uint32_t p = 0; p < reports.size(); ++p) {
      if (!reports[PlaceIndex{p}]) continue;
      weights[0].push_back({PlaceIndex{p}, p + 1.0});
      sum += p + 1;
    }
    for (PlaceWeight& w : weights[0]) w.weight /= sum;
    return weights;
  }
};

/// Four places, of which the first has three stations and the third two.
class MethodWeigherOf : public testing::Test {
 protected:
  const Study study_{{{"a", {0, 0}},
                      {"b", {1, 0}},
                      {"c", {0, 0}},
                      {"d", {2, 0}},
                      {"e", {0, 0}},
                      {"f", {3, 0}},
                      {"g", {2, 0}}},
                     {shapes::basin({{shapes::rectangle({0, 0}, {5, 4}), {}}}),
                      shapes::basin({{shapes::rectangle({0, 0}, {1, 1}), {}}})},
                     plane};
  const MethodWeigher weigher_{study_.weighing, std::make_unique<const ByNumber>(), 1000};

  static std::vector<double> weights_of(const BasinWeights& basin) {
    std::vector<double> weights;
    for (const StationWeight& s : basin.stations) weights.push_back(s.weight);
    return weights;
  }
};

TEST_F(MethodWeigherOf, law_1_full_weights_are_shared_by_the_stations_of_a_place_in_their_order) {
  const auto full = weigher_.full_weights();
  ASSERT_EQ(full.size(), 2u);
  const std::vector<double> expected{1. / 30, 0.2, 1. / 30, 0.15, 1. / 30, 0.4, 0.15};
  ASSERT_EQ(full[0].stations.size(), expected.size());
  for (std::uint32_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(full[0].stations[i].station, StationIndex{i});
    EXPECT_NEAR(full[0].stations[i].weight, expected[i], 1e-16);
    EXPECT_NEAR(full[0].stations[i].area, 20 * expected[i], 1e-14);
  }
  EXPECT_EQ(full[0].area, 20);
  EXPECT_EQ(full[1].area, 1);
  EXPECT_TRUE(full[1].stations.empty());
}

TEST_F(MethodWeigherOf, law_2_stations_that_are_silent_leave_their_share_to_others_at_the_place) {
  const ReportingStations reports{true, true, false, true, true, false, false};
  const auto weights = weigher_.by_station({{{PlaceIndex{0}, 0.5}, {PlaceIndex{2}, 0.5}}}, reports);
  ASSERT_EQ(weights.size(), 1u);
  EXPECT_EQ(weights_of(weights[0]), (std::vector<double>{0.25, 0.5, 0.25}));
  EXPECT_EQ(weights[0].stations[1].station, StationIndex{3});
}

TEST_F(MethodWeigherOf, law_3_retessellation_asks_the_method_for_the_places_that_report) {
  const auto policy = weigher_.retessellation();
  const std::vector<double> readings{silent, 7, 4, silent, 2, silent, silent};
  const auto values = policy->at(readings);
  EXPECT_DOUBLE_EQ(values[0].rainfall, (3 + 2 * 7) / 3.);
  EXPECT_EQ(values[0].gauges, 3u);
  EXPECT_TRUE(std::isnan(values[1].rainfall));
  EXPECT_TRUE(policy->leaves_silent_out());
}

}  // namespace
}  // namespace thiessen

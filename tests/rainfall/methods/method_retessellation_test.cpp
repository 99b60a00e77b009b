// A method anew among the gauges that report, beside the method of a network made of these alone.
#include "rainfall/methods/method_retessellation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "rainfall/gaps/gappy_study.h"

namespace thiessen {
namespace {

using Make = std::function<std::unique_ptr<const AreaMethod>(const Weighing&)>;

TEST(MethodRetessellation, weights_are_those_of_the_method_without_the_silent_gauges) {
  Seeded seeded;
  const gappy::Study study = gappy::random_study(seeded);
  const Make arithmetic = [](const Weighing& w) {
    return std::make_unique<const ArithmeticMean>(w);
  };
  const Make idw = [](const Weighing& w) {
    return std::make_unique<const InverseDistance>(w, 50, 1);
  };
  for (const Make& make : {arithmetic, idw}) {
    const MethodWeigher weigher(study.weighing, make(study.weighing), 100'000);
    const auto policy = weigher.retessellation();
    for (const double share : {0.05, 0.4, 0.9}) {
      const auto readings = gappy::readings_of(seeded, study, share);
      const gappy::Study rest = study.without_silent(readings);
      const MethodWeigher of_rest(rest.weighing, make(rest.weighing), 0);
      const auto expected = of_rest.full_weights();
      const auto found = policy->weights_at(readings);
      std::vector<StationIndex> reporting;
      for (std::uint32_t s = 0; s < readings.size(); ++s) {
        if (!std::isnan(readings[s])) reporting.push_back(StationIndex{s});
      }
      for (std::size_t b = 0; b < found.size(); ++b) {
        ASSERT_EQ(found[b].stations.size(), expected[b].stations.size());
        for (std::size_t i = 0; i < found[b].stations.size(); ++i) {
          EXPECT_EQ(found[b].stations[i].station,
                    reporting[index(expected[b].stations[i].station)]);
          const double weight = expected[b].stations[i].weight;
          EXPECT_NEAR(found[b].stations[i].weight, weight, 1e-7 * weight);  // idw keeps floats
        }
      }
    }
  }
}

TEST(MethodRetessellation, gauges_at_one_place_are_one_gauge_of_the_mean_of_those_that_report) {
  const gappy::Study study({{"a", {1, 1}, 2}, {"b", {3, 1}, 3}, {"c", {1, 1}, 4}},
                           {shapes::basin({{shapes::rectangle({0, 0}, {4, 2}), {}}})});
  const MethodWeigher weigher(study.weighing,
                              std::make_unique<const ArithmeticMean>(study.weighing), 1000);
  const auto policy = weigher.retessellation();
  const auto value = [&](std::vector<double> readings) { return policy->at(readings)[0]; };
  EXPECT_DOUBLE_EQ(value({10, 40, 20}).rainfall, ((10 + 20) / 2.0 + 40) / 2);
  EXPECT_DOUBLE_EQ(value({10, 40, gappy::silent}).rainfall, (10 + 40) / 2.0);
}

}  // namespace
}  // namespace thiessen

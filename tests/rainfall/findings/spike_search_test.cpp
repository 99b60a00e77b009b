#include "rainfall/findings/spike_search.h"

#include <gtest/gtest.h>

#include "rainfall/findings/ring_of_gauges.h"

namespace thiessen {
namespace {

TEST(SpikeSearch, finds_what_is_above_the_bound_and_three_times_the_largest_neighbour) {
  const GaugeNeighbours ring = ring_of(4);
  SpikeSearch search(ring, 10);
  ShownSteps steps(search);
  steps.show("a", {22.1, 4, 1, 0, 2});  // 10 and 3 times 4 are 22
  steps.show("b", {22, 4, 1, 0, 2});
  ASSERT_EQ(steps.found.size(), 1u);
  EXPECT_EQ(steps.found[0].station, StationIndex{0});
  EXPECT_EQ(steps.found[0].kind, FindingKind::spike);
  EXPECT_EQ(steps.found[0].time, "a");
  EXPECT_EQ(steps.found[0].value, 22.1);
  EXPECT_EQ(steps.found[0].expected, 1.5);  // the median of 0, 1, 2 and 4
}

TEST(SpikeSearch, wants_three_neighbours_that_report) {
  const GaugeNeighbours ring = ring_of(4);
  SpikeSearch search(ring, 10);
  ShownSteps steps(search);
  steps.show("a", {90, 0, silent, silent, 0});
  EXPECT_TRUE(steps.found.empty());
  steps.show("b", {90, 0, silent, 0, 0});
  EXPECT_EQ(steps.found.size(), 1u);
}

TEST(SpikeSearch, takes_the_99th_hundredth_of_wet_readings_where_no_bound_is_given) {
  const GaugeNeighbours ring = ring_of(4);
  SpikeSearch search(ring, std::nullopt);
  ShownSteps steps(search);
  // 1 to 100, each four times: 99 in 100 are not above 99.
  for (int reading = 1; reading <= 100; ++reading) {
    const double amount = reading;
    steps.show("wet", {0, amount, amount, amount, amount});
  }
  search.settle([](StationIndex) { return true; });
  EXPECT_NEAR(search.bound(), 99, 3);
}

TEST(SpikeSearch, has_no_bound_of_fewer_than_a_hundred_wet_readings) {
  const GaugeNeighbours ring = ring_of(4);
  SpikeSearch search(ring, std::nullopt);
  ShownSteps steps(search);
  for (int i = 0; i < 99; ++i) steps.show("wet", {5, 0, 0, 0, 0});
  search.settle([](StationIndex) { return true; });
  EXPECT_TRUE(std::isnan(search.bound()));
}

TEST(SpikeSearch, leaves_gauges_of_another_unit_out_of_the_bound) {
  const GaugeNeighbours ring = ring_of(4);
  SpikeSearch search(ring, std::nullopt);
  ShownSteps steps(search);
  for (int i = 0; i < 50; ++i) steps.show("wet", {1000, 4, 4, 4, 4});
  search.settle([](StationIndex gauge) { return gauge != StationIndex{0}; });
  EXPECT_NEAR(search.bound(), 4, 0.3);
}

}  // namespace
}  // namespace thiessen

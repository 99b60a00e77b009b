#include "cli/outputs/maps_of.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

TEST(MapsOf, a_network_is_one_map_by_station) {
  const GivenInputs given;
  const auto maps = maps_of(given.inputs, {}, given.options(), {}, 1);
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_FALSE(maps[0].by_rainfall);
  EXPECT_EQ(maps[0].cells.size(), 2U);
}

TEST(MapsOf, each_step_has_its_own_tessellation_and_the_page_says_all_times) {
  const GivenInputs given;
  const std::vector<GaugeReadings> steps = {{{1, 2}, "t1"}, {{std::nan(""), 5}, "t2"}};
  const auto maps = maps_of(given.inputs, steps, given.options(), {}, 1);
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[0].subtitle, "t1");
  EXPECT_EQ(maps[0].cells.size(), 2U);
  EXPECT_EQ(maps[1].subtitle, "t2");
  ASSERT_EQ(maps[1].cells.size(), 1U) << "the ground of the silent gauge is handed over";
  EXPECT_EQ(maps[1].cells[0].rainfall, 5);
  EXPECT_FALSE(maps[1].gauges[0].reports);
  EXPECT_EQ(maps[0].tags.back().second, "t1, t2");
}

}  // namespace
}  // namespace thiessen::cli

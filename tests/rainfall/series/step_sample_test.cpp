#include "rainfall/series/step_sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace thiessen {
namespace {

// Step t reads t at the first station and silence at the second.
StepSample sample_of(std::size_t steps, std::size_t most) {
  StepSample sample(2, most);
  for (std::size_t t = 0; t < steps; ++t) {
    sample.add(std::vector{static_cast<double>(t), std::numeric_limits<double>::quiet_NaN()});
  }
  return sample;
}

TEST(StepSample, keeps_all_while_there_is_room) {
  const StepSample sample = sample_of(7, 7);
  ASSERT_EQ(sample.steps(), 7u);
  EXPECT_EQ(sample.spacing(), 1u);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(sample[i][0], static_cast<double>(i));
    EXPECT_TRUE(std::isnan(sample[i][1]));
  }
}

// Laws, for any length and room: every kept step is a multiple of the spacing, none of these is
// left out, no more are kept than there is room for and no fewer than half of it.
TEST(StepSample, is_evenly_spaced_over_the_whole_series) {
  for (std::size_t most = 2; most < 20; ++most) {
    for (std::size_t steps = 0; steps < 300; ++steps) {
      const StepSample sample = sample_of(steps, most);
      const std::size_t spacing = sample.spacing();
      ASSERT_EQ(sample.steps(), (steps + spacing - 1) / spacing);
      ASSERT_LE(sample.steps(), most);
      if (steps >= most) {
        ASSERT_GE(2 * sample.steps(), most);
      }
      for (std::size_t i = 0; i < sample.steps(); ++i)
        ASSERT_EQ(sample[i][0], static_cast<double>(i * spacing));
    }
  }
}

TEST(StepSample, keeps_the_months_of_the_steps_that_it_keeps) {
  for (std::size_t most = 2; most < 6; ++most) {
    StepSample sample(1, most);
    for (std::size_t t = 0; t < 40; ++t) sample.add(std::vector{static_cast<double>(t)}, t % 12);
    ASSERT_EQ(sample.months().size(), sample.steps());
    for (std::size_t i = 0; i < sample.steps(); ++i)
      EXPECT_EQ(sample.months()[i], static_cast<std::size_t>(sample[i][0]) % 12);
  }
  EXPECT_TRUE(sample_of(5, 9).months().empty());
}

TEST(StepSample, has_the_room_that_the_memory_gives) {
  EXPECT_EQ(steps_within(8'000, 10, 1'000), 100u);
  EXPECT_EQ(steps_within(8'000, 10, 50), 50u);
  EXPECT_EQ(steps_within(8, 10, 50), 2u);
  EXPECT_EQ(steps_within(8, 0, 50), 2u);  // no stations
}

}  // namespace
}  // namespace thiessen

#include "rainfall/leaving_out/processor_time.h"

#include <gtest/gtest.h>

#include <cstddef>

namespace thiessen {
namespace {

TEST(TimedSteps, are_all_of_a_short_series) {
  TimedSteps steps;
  for (std::size_t i = 0; i < TimedSteps::all_of_first; ++i) EXPECT_EQ(steps.next(), 1u) << i;
}

TEST(TimedSteps, stand_for_all_of_a_long_series) {
  TimedSteps steps;
  std::size_t timed = 0;
  std::size_t stood_for = 0;
  for (std::size_t i = 1; i <= 100'000; ++i) {
    const std::size_t times = steps.next();
    timed += times > 0 ? 1U : 0U;
    stood_for += times;
    EXPECT_LE(i > stood_for ? i - stood_for : stood_for - i, TimedSteps::one_in) << i;
  }
  EXPECT_LE(timed, TimedSteps::all_of_first + 100'000 / TimedSteps::one_in + 1);
}

}  // namespace
}  // namespace thiessen

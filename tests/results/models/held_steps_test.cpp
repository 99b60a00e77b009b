#include "results/models/held_steps.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace thiessen {
namespace {

using Values = std::vector<double>;

Values copy_of(std::span<const double> values) {
  return {values.begin(), values.end()};
}

TEST(HeldSteps, are_handed_out_by_step_as_often_as_asked_for) {
  HeldSteps steps(2);
  steps.add(-60, Values{1, 2});
  steps.add(60, Values{3, 4});
  EXPECT_EQ(steps.count(), 2);
  for (int round = 0; round < 2; ++round) {
    std::vector<std::pair<std::int64_t, Values>> found;
    steps.by_step([&](std::int64_t seconds, std::span<const double> values) {
      found.emplace_back(seconds, copy_of(values));
    });
    EXPECT_EQ(found, (std::vector<std::pair<std::int64_t, Values>>{{-60, {1, 2}}, {60, {3, 4}}}));
  }
}

TEST(HeldSteps, are_handed_out_by_basin_whatever_memory_is_allowed) {
  for (const std::size_t memory : {std::size_t{1}, std::size_t{64}, std::size_t{1} << 20}) {
    HeldSteps steps(3, memory);
    for (int i = 0; i < 4; ++i) steps.add(i, Values{1.0 * i, 10.0 * i, 100.0 * i});
    std::vector<Values> found;
    steps.by_basin([&](std::size_t basin, std::span<const double> values) {
      EXPECT_EQ(basin, found.size());
      found.push_back(copy_of(values));
    });
    EXPECT_EQ(found, (std::vector<Values>{{0, 1, 2, 3}, {0, 10, 20, 30}, {0, 100, 200, 300}}));
  }
}

TEST(HeldSteps, of_many_megabytes_come_back_as_they_were) {
  constexpr std::size_t count = 300'000;
  HeldSteps steps(1);
  for (std::size_t i = 0; i < count; ++i)
    steps.add(static_cast<std::int64_t>(i), Values{static_cast<double>(i) / 8});
  std::size_t next = 0;
  bool are_right = true;
  steps.by_step([&](std::int64_t seconds, std::span<const double> values) {
    are_right = are_right && seconds == static_cast<std::int64_t>(next) &&
                values[0] == static_cast<double>(next) / 8;
    ++next;
  });
  EXPECT_TRUE(are_right);
  EXPECT_EQ(next, count);
}

}  // namespace
}  // namespace thiessen

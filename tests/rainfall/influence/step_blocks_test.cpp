#include "rainfall/influence/step_blocks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rainfall/series/readings_of.h"
#include "rainfall/series/stamp.h"
#include "rainfall/series/step_months.h"

namespace thiessen {
namespace {

// ReadingsOf: step i reads i.
TEST(StepBlocks, hold_all_steps_in_order) {
  for (const std::size_t steps : {0u, 1u, 4u, 5u, 8u, 13u}) {
    for (const unsigned threads : {1u, 2u}) {
      ReadingsOf readings(std::vector<std::string>(steps, "2000"));
      std::size_t next = 0;
      for_each_block(readings, 4, threads, {}, [&](const StepBlock& block) {
        const StepRows rows = block.rows;
        EXPECT_TRUE(block.months.empty());
        EXPECT_TRUE(rows.size() == 4 || next + rows.size() == steps);
        EXPECT_FALSE(rows.empty());
        for (const auto row : rows) {
          ASSERT_EQ(row.size(), 1u);
          EXPECT_EQ(row[0], static_cast<double>(next++));
        }
      });
      EXPECT_EQ(next, steps);
    }
  }
}

TEST(StepBlocks, hold_the_months_that_are_wanted) {
  const std::vector<std::string> times{"2000-01", "2000-02", "2000-12", "2001-02", "2001-03"};
  const std::vector<std::size_t> months{0, 1, 11, 1, 2};
  ReadingsOf readings(times);
  std::vector<std::size_t> told;
  for_each_block(
      readings, 2, 1,
      [](const TimeStep& step) { return *month_of(step.time, step.written, Stamp::begin); },
      [&](const StepBlock& block) {
        EXPECT_EQ(block.months.size(), block.rows.size());
        told.insert(told.end(), block.months.begin(), block.months.end());
      });
  EXPECT_EQ(told, months);
}

TEST(StepBlocks, hand_on_what_reading_and_taking_throw) {
  for (const unsigned threads : {1u, 2u}) {
    ReadingsOf bad(std::vector<std::string>(9, "2000"), Message{"rain.csv", 11, "is bad", ""});
    EXPECT_THROW(for_each_block(bad, 4, threads, {}, [](const StepBlock&) {}), Error);
    ReadingsOf good(std::vector<std::string>(9, "2000"));
    EXPECT_THROW(for_each_block(good, 4, threads, {}, [](const StepBlock&) { throw 7; }), int);
  }
}

}  // namespace
}  // namespace thiessen

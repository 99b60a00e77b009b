#include "rainfall/influence/step_blocks.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "rainfall/series/readings_of.h"

namespace thiessen {
namespace {

// ReadingsOf: step i reads i.
TEST(StepBlocks, hold_all_steps_in_order) {
  for (const std::size_t steps : {0u, 1u, 4u, 5u, 8u, 13u}) {
    for (const unsigned threads : {1u, 2u}) {
      ReadingsOf readings(std::vector<std::string>(steps, "2000"));
      std::size_t next = 0;
      for_each_block(readings, 4, threads, [&](StepRows rows) {
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

TEST(StepBlocks, hand_on_what_reading_and_taking_throw) {
  for (const unsigned threads : {1u, 2u}) {
    ReadingsOf bad(std::vector<std::string>(9, "2000"), Message{"rain.csv", 11, "is bad", ""});
    EXPECT_THROW(for_each_block(bad, 4, threads, [](StepRows) {}), Error);
    ReadingsOf good(std::vector<std::string>(9, "2000"));
    EXPECT_THROW(for_each_block(good, 4, threads, [](StepRows) { throw 7; }), int);
  }
}

}  // namespace
}  // namespace thiessen

#include "base/memory.h"

#include <gtest/gtest.h>

#include <limits>

namespace thiessen {
namespace {

TEST(Memory, is_had_in_reason_and_is_not_taken_by_asking) {
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(can_have(std::size_t{16} << 20));
  EXPECT_TRUE(can_have(0));
  EXPECT_FALSE(can_have(std::numeric_limits<std::size_t>::max() / 4));
}

}  // namespace
}  // namespace thiessen

#include "base/default_arithmetic.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <thread>

namespace thiessen {
namespace {

/// 1/3, rounded as the thread rounds: the compiler may not do it beforehand.
double third() {
  volatile double one = 1;
  return one / 3;
}

TEST(DefaultArithmetic, rounds_to_the_nearest_and_leaves_the_callers_mode_behind) {
  const double nearest = third();
  ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
  EXPECT_GT(third(), nearest);
  {
    const DefaultArithmetic arithmetic;
    EXPECT_EQ(third(), nearest);
    std::thread([&] {
      EXPECT_EQ(third(), nearest) << "in a thread that is begun meanwhile";
    }).join();
  }
  EXPECT_EQ(std::fegetround(), FE_UPWARD);
  std::fesetround(FE_TONEAREST);
}

}  // namespace
}  // namespace thiessen

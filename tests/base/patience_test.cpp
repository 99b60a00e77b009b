// How long what is known of a feed is held back.
#include "base/patience.h"

#include <gtest/gtest.h>

#include <thread>

namespace thiessen {
namespace {

using std::chrono::milliseconds;

TEST(Patience, gets_shorter_once_half_a_second_has_passed_and_can_be_renewed) {
  Patience patience;
  EXPECT_EQ(patience.left(), milliseconds(250));
  std::this_thread::sleep_for(milliseconds(510));
  EXPECT_EQ(patience.left(), milliseconds(50));
  patience.renew();
  EXPECT_EQ(patience.left(), milliseconds(250));
}

}  // namespace
}  // namespace thiessen

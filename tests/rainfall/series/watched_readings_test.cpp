#include "rainfall/series/watched_readings.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rainfall/series/readings_of.h"

namespace thiessen {
namespace {

TEST(WatchedReadings, tell_how_much_is_read) {
  WatchedReadings readings(
      std::make_unique<ReadingsOf>(std::vector<std::string>{"2012", "2013", "2014", "2015"}));
  EXPECT_TRUE(std::isnan(readings.share_read()));
  TimeStep step;
  EXPECT_TRUE(readings.next(step));
  EXPECT_EQ(readings.share_read(), 0.25);
  EXPECT_TRUE(readings.next(step) && readings.next(step));
  EXPECT_EQ(readings.share_read(), 0.75);
  EXPECT_EQ(readings.share_of(0), 0);
  EXPECT_EQ(readings.share_of(2), 0.5);
}

}  // namespace
}  // namespace thiessen

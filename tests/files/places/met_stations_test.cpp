#include "files/places/met_stations.h"

#include <gtest/gtest.h>

#include <string>

namespace thiessen {
namespace {

TEST(MetStations, are_found_again_as_they_came_first) {
  MetStations met;
  EXPECT_EQ(met.meet({"a", {1, 2}, 3}), nullptr);
  EXPECT_EQ(met.meet({"", {3, 4}, 5}), nullptr);
  EXPECT_EQ(met.meet({"A", {1, 2}, 6}), nullptr);
  const Station* const first = met.meet({"a", {7, 8}, 9});
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->id, "a");
  EXPECT_EQ(first->position, (Point{1, 2}));
  EXPECT_EQ(first->line, 3U);
}

TEST(MetStations, may_be_many) {
  MetStations met;
  for (std::size_t i = 0; i < 5000; ++i)
    ASSERT_EQ(met.meet({"station " + std::to_string(i), {}, i}), nullptr);
  for (std::size_t i = 0; i < 5000; ++i) {
    const Station* const first = met.meet({"station " + std::to_string(i), {}, 0});
    ASSERT_NE(first, nullptr);
    EXPECT_EQ(first->line, i);
  }
}

}  // namespace
}  // namespace thiessen

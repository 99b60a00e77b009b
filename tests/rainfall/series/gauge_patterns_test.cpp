#include "rainfall/series/gauge_patterns.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

TEST(GaugePatterns, are_numbered_as_they_come) {
  GaugePatterns patterns;
  const auto expect = [&](const std::vector<double>& readings, std::size_t number, bool is_fresh) {
    const auto found = patterns.of(readings);
    EXPECT_EQ(found.number, number);
    EXPECT_EQ(found.is_fresh, is_fresh);
  };
  expect({1, 2, 3}, 1, true);
  expect({1, silent, 3}, 2, true);
  expect({0, 0, 0}, 1, false);
  expect({silent, silent, silent}, 3, true);
  expect({7, silent, 8}, 2, false);
}

// Law: each of 130 gauges alone silent, and each two of them, is a set of its own.
TEST(GaugePatterns, tell_every_gauge_from_every_other) {
  GaugePatterns patterns;
  constexpr std::size_t gauges = 130;
  std::size_t count = 0;
  for (std::size_t i = 0; i < gauges; ++i) {
    for (std::size_t j = i; j < gauges; ++j) {
      std::vector<double> readings(gauges, 1.5);
      readings[i] = readings[j] = silent;
      EXPECT_TRUE(patterns.of(readings).is_fresh);
      EXPECT_EQ(patterns.of(readings).number, ++count);
    }
  }
}

}  // namespace
}  // namespace thiessen

#include "rainfall/normals/elevation_units.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace thiessen {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

TEST(ElevationUnits, are_told_by_the_median_ratio) {
  // Pixels are off by up to 30 %, and one by much more.
  const std::vector<double> metres{300, 800, 1200, 1800, 2400, none};
  const std::vector<double> pixels{390, 790, 1150, 400, 2410, 700};
  EXPECT_EQ(judge_feet(metres, pixels), InFeet::nobody);
  EXPECT_EQ(judge_feet(times(3.2808, metres), pixels), InFeet::stations);
  EXPECT_EQ(judge_feet(metres, times(3.2808, pixels)), InFeet::raster);
  EXPECT_EQ(judge_feet(times(3.2808, metres), times(3.2808, pixels)), InFeet::nobody);
  EXPECT_EQ(judge_feet(times(2, metres), pixels), InFeet::nobody);
}

TEST(ElevationUnits, are_not_told_by_few_gauges_or_by_the_shore) {
  EXPECT_EQ(judge_feet(std::vector<double>{3281, 656}, std::vector<double>{1000, 200}),
            InFeet::nobody);
  EXPECT_EQ(judge_feet(std::vector<double>{33, 66, 16, -300}, std::vector<double>{10, 20, 5, -90}),
            InFeet::nobody);
}

}  // namespace
}  // namespace thiessen

#include "rainfall/normals/uniform_normals.h"

#include <gtest/gtest.h>

#include <vector>

namespace thiessen {
namespace {

// Two months: the first station has 20 and 60, 40 a month in the year.
TEST(UniformNormals, are_those_of_stations_and_basins) {
  const UniformNormals normals({{20, 60}, {40, 30}}, {{10, 90}, {20, 60}});
  EXPECT_EQ(normals.months(), 2u);
  EXPECT_EQ(normals.at_gauge(StationIndex{1}, 0), 40);
  EXPECT_EQ(relative_at_gauge(normals, StationIndex{1}, 1), 0.5);
  EXPECT_EQ(normals.in(0).of({}, 1, 1).mean, 90);
  EXPECT_EQ(normals.in(1).whole(1).mean, 60);
  EXPECT_EQ(normals.in(1).at({0, 0}, 1), 60);
  EXPECT_EQ(normals.in(1).measure(), nullptr);
  EXPECT_EQ(normal_at_gauge(normals, StationIndex{1}, {}), 35);
  EXPECT_EQ(normal_over(normals, 0, {}, 1, {}).mean, 50);
  EXPECT_EQ(reference_normal(normals, {}), 40);
}

}  // namespace
}  // namespace thiessen

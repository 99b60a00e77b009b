#include "rainfall/normals/series_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "geometry/seeded.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

std::vector<double> normals_of(const std::vector<std::vector<double>>& steps) {
  SeriesNormals normals(steps.front().size());
  for (const auto& readings : steps) normals.add(readings);
  return normals.result();
}

TEST(SeriesNormals, are_means_where_all_report) {
  const std::vector<double> normals = normals_of({{1, 2, 6}, {3, 0, 0}, {2, 1, 3}});
  EXPECT_NEAR(normals[0], 2, 1e-9);
  EXPECT_NEAR(normals[1], 1, 1e-9);
  EXPECT_NEAR(normals[2], 3, 1e-9);
}

// With readings that are normal x state exactly, the ratios of the normals come out whatever is
// silent, as long as the gauges that share steps join all.
TEST(SeriesNormals, do_not_depend_on_which_steps_a_gauge_lacks) {
  Seeded seeded;
  const std::vector<double> truth = {1, 2, 4, 0.5, 3};
  std::vector<std::vector<double>> steps;
  for (int t = 0; t < 60; ++t) {
    const double state = seeded.uniform(0, 1) < 0.3 ? 0 : seeded.uniform(0, 20);
    std::vector<double> readings;
    for (const double normal : truth)
      readings.push_back(seeded.uniform(0, 1) < 0.4 ? silent : normal * state);
    steps.push_back(readings);
  }
  const std::vector<double> normals = normals_of(steps);
  for (std::size_t i = 1; i < truth.size(); ++i)
    EXPECT_NEAR(normals[i] / normals[0], truth[i] / truth[0], 1e-6) << i;
}

// By hand: b lacks the wet step. Of r = N s with a's readings 10 and 2, b reads 1 at the second: so
// b's normal is half of a's, though its mean reading is a sixth.
TEST(SeriesNormals, of_a_gauge_that_lacks_the_wet_step) {
  const std::vector<double> normals = normals_of({{10, silent}, {2, 1}});
  EXPECT_NEAR(normals[1] / normals[0], 0.5, 1e-6);
}

TEST(SeriesNormals, of_a_gauge_that_is_always_dry_or_silent) {
  SeriesNormals series(3);
  series.add(std::vector<double>{5, 0, silent});
  series.add(std::vector<double>{1, 0, silent});
  const std::vector<double> normals = series.result();
  EXPECT_NEAR(normals[0], 3, 1e-9);
  EXPECT_EQ(normals[1], 0);
  EXPECT_TRUE(std::isnan(normals[2]));
  EXPECT_EQ(series.readings_of(1), 2u);
  EXPECT_EQ(series.readings_of(2), 0u);
}

TEST(SeriesNormals, of_a_series_without_rain) {
  const std::vector<double> normals = normals_of({{0, 0}, {0, silent}});
  EXPECT_EQ(normals[0], 0);
  EXPECT_EQ(normals[1], 0);
}

}  // namespace
}  // namespace thiessen

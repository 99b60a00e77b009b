#include "rainfall/leaving_out/elevation_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace thiessen {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> names_of(const ElevationBands& bands) {
  std::vector<std::string> names;
  for (std::size_t band = 0; band < bands.size(); ++band) names.push_back(bands.name(band));
  return names;
}

std::vector<double> evenly(double from, double step, int count) {
  std::vector<double> elevations;
  for (int i = 0; i < count; ++i) elevations.push_back(from + step * i);
  return elevations;
}

// Of 820, 920, ... 3,720 the terciles are 1,820 and 2,820, a quarter of whose difference is 250.
TEST(ElevationBands, have_bounds_that_a_person_would_choose) {
  const ElevationBands bands(evenly(820, 100, 30));
  EXPECT_EQ(names_of(bands),
            (std::vector<std::string>{"below 1,800", "1,800 to 2,800", "above 2,800"}));
  EXPECT_EQ(bands.bounds(), (std::vector<double>{1800, 2800}));
  EXPECT_EQ(bands.of(0), 0u);
  EXPECT_EQ(bands.of(10), 1u);
  EXPECT_EQ(bands.of(29), 2u);
}

// Terciles 3.75 and 4.75: a quarter of what is between is 0.25, so steps of 0.2. Then -6 and 4, in
// steps of 2.
TEST(ElevationBands, of_low_country) {
  EXPECT_EQ(names_of(ElevationBands(evenly(2.75, 0.1, 30))),
            (std::vector<std::string>{"below 3.8", "3.8 to 4.8", "above 4.8"}));
  EXPECT_EQ(names_of(ElevationBands(evenly(-16, 1, 30))),
            (std::vector<std::string>{"below -6", "-6 to 4", "above 4"}));
}

TEST(ElevationBands, a_gauge_at_a_bound_is_in_the_upper_band) {
  const ElevationBands bands(evenly(0, 100, 31));
  ASSERT_EQ(bands.bounds(), (std::vector<double>{1000, 2000}));
  EXPECT_EQ(bands.of(9), 0u);
  EXPECT_EQ(bands.of(10), 1u);
  EXPECT_EQ(bands.of(20), 2u);
}

TEST(ElevationBands, a_gauge_of_unknown_elevation_is_in_none) {
  std::vector<double> elevations = evenly(820, 100, 30);
  elevations.insert(elevations.begin(), unknown);
  const ElevationBands bands(elevations);
  EXPECT_EQ(bands.of(0), std::nullopt);
  EXPECT_EQ(bands.of(1), 0u);
  EXPECT_EQ(bands.bounds(), (std::vector<double>{1800, 2800}));
}

TEST(ElevationBands, few_gauges_and_one_height_make_one) {
  EXPECT_EQ(names_of(ElevationBands(evenly(100, 500, 5))), (std::vector<std::string>{"all"}));
  const ElevationBands level(std::vector<double>(40, 320));
  EXPECT_EQ(names_of(level), (std::vector<std::string>{"all"}));
  EXPECT_EQ(level.of(39), 0u);
}

// Half of the gauges stand at 0, as unknown elevations are often written: a bound at 0 would leave
// the lowest band empty. The other, of 1,500 in steps of 200, is 1,600.
TEST(ElevationBands, have_gauges_each) {
  std::vector<double> elevations = evenly(1000, 100, 15);
  elevations.insert(elevations.end(), 15, 0);
  const ElevationBands bands(elevations);
  std::vector<int> counts(bands.size());
  for (std::size_t i = 0; i < elevations.size(); ++i) ++counts[*bands.of(i)];
  EXPECT_EQ(counts, (std::vector<int>{21, 9}));
}

TEST(ElevationBands, are_none_where_no_elevation_is_known) {
  EXPECT_EQ(ElevationBands({}).size(), 0u);
  const ElevationBands bands(std::vector<double>(9, unknown));
  EXPECT_EQ(bands.size(), 0u);
  EXPECT_EQ(bands.of(3), std::nullopt);
  EXPECT_EQ(bands.of(99), std::nullopt);
}

}  // namespace
}  // namespace thiessen

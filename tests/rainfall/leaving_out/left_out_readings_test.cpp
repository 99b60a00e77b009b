#include "rainfall/leaving_out/left_out_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/seeded.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

constexpr double silent = std::numeric_limits<double>::quiet_NaN();

/// Normals of which leaving a gauge out changes each by a known factor.
class ToldByOthers : public UniformNormals {
 public:
  ToldByOthers(const std::vector<double>& gauges, double times)
      : UniformNormals(by_month(gauges), {}), times_(times) {}
  double without(StationIndex station, std::size_t month) const override {
    return times_ * at_gauge(station, month);
  }

 private:
  static std::vector<std::vector<double>> by_month(const std::vector<double>& gauges) {
    std::vector<std::vector<double>> rows;
    for (const double normal : gauges) rows.push_back({normal});
    return rows;
  }
  double times_;
};

// Gauges at 0, 1, 3 and 7 on a line: each one's nearest is the one on its left, but for the first,
// whose is the second.
Network on_a_line() {
  return {{{"a", {0, 0}}, {"b", {1, 0}}, {"c", {3, 0}}, {"d", {7, 0}}}, Metric::planar};
}

TEST(LeftOutReadings, of_four_gauges_on_a_line) {
  const Network network = on_a_line();
  LeftOutReadings left_out(network, Metric::planar, nullptr, ElevationBands({}));
  left_out.add(std::vector<double>{10, 12, 20, 5}, {});
  const ErrorSums& plain = left_out.all().plain;
  EXPECT_EQ(plain.count, 4u);
  EXPECT_EQ(plain.errors, 2 - 2 - 8 + 15);
  EXPECT_EQ(plain.squares, 4 + 4 + 64 + 225);
  EXPECT_EQ(left_out.all().with_normals.count, 0u);
}

TEST(LeftOutReadings, are_told_by_gauges_that_report) {
  const Network network = on_a_line();
  LeftOutReadings left_out(network, Metric::planar, nullptr, ElevationBands({}));
  left_out.add(std::vector<double>{10, silent, 20, 5}, {});  // a by c, c by a, d by c
  EXPECT_EQ(left_out.all().plain.squares, 100 + 100 + 225);
  left_out.add(std::vector<double>{silent, silent, 20, silent}, {});  // nobody tells
  left_out.add(std::vector<double>{silent, silent, silent, silent}, {});
  EXPECT_EQ(left_out.all().plain.count, 3u);
}

// Readings that are normal x state exactly have no error with normals, and with normals that the
// others tell twice as large as they are an error as large as the reading.
TEST(LeftOutReadings, count_times_the_normal_that_the_others_tell) {
  const Network network = on_a_line();
  for (const double times : {1.0, 2.0}) {
    const ToldByOthers normals({100, 400, 200, 50}, times);
    LeftOutReadings left_out(network, Metric::planar, &normals, ElevationBands({}));
    left_out.add(std::vector<double>{10, 40, 20, 5}, 0);
    EXPECT_EQ(left_out.all().with_normals.count, 4u);
    EXPECT_NEAR(left_out.all().with_normals.errors, (times - 1) * 75, 1e-12);
    EXPECT_NEAR(left_out.all().plain.errors, 30 - 30 + 20 + 15, 1e-12);
  }
}

TEST(LeftOutReadings, with_normals_of_months_and_of_the_year) {
  const Network network({{"a", {0, 0}}, {"b", {1, 0}}}, Metric::planar);
  std::vector<std::vector<double>> gauges(2, std::vector<double>(12, 1));
  gauges[1][6] = 13;  // the mean of b's year is 2
  const UniformNormals normals(gauges, {});
  LeftOutReadings left_out(network, Metric::planar, &normals, ElevationBands({}));
  left_out.add(std::vector<double>{1, 13}, 6);
  left_out.add(std::vector<double>{5, 5}, 0);
  left_out.add(std::vector<double>{3, 6}, {});
  EXPECT_NEAR(left_out.all().with_normals.squares, 0, 1e-24);
}

TEST(LeftOutReadings, leave_gauges_at_one_place_out_together) {
  const Network network({{"a", {0, 0}}, {"twin", {0, 0}}, {"b", {1, 0}}}, Metric::planar);
  LeftOutReadings left_out(network, Metric::planar, nullptr, ElevationBands({}));
  left_out.add(std::vector<double>{10, 20, 40}, {});  // both by b; b by their mean
  EXPECT_EQ(left_out.all().plain.errors, 30 + 20 - 25);
  EXPECT_EQ(left_out.all().plain.squares, 900 + 400 + 625);
}

TEST(LeftOutReadings, by_bands) {
  const std::vector<double> elevations{1, 1, 1, 9, 9, 9, silent};
  std::vector<Station> stations;
  for (int i = 0; i < 7; ++i) stations.push_back({std::to_string(i), {i * (1 + 0.1 * i), 0}});
  const Network network(stations, Metric::planar);
  LeftOutReadings left_out(network, Metric::planar, nullptr, ElevationBands(elevations));
  ASSERT_EQ(left_out.bands().size(), 2u);
  left_out.add(std::vector<double>{0, 1, 3, 6, 10, 15, 21}, {});
  EXPECT_EQ(left_out.in_band(0).plain.errors, 1 - 1 - 2);
  EXPECT_EQ(left_out.in_band(1).plain.errors, -3 - 4 - 5);
  EXPECT_EQ(left_out.all().plain.count, 7u);
}

TEST(LeftOutReadings, of_a_single_gauge_are_none) {
  const Network network({{"a", {0, 0}}}, Metric::planar);
  LeftOutReadings left_out(network, Metric::planar, nullptr, ElevationBands({}));
  left_out.add(std::vector<double>{10}, {});
  EXPECT_EQ(left_out.all().plain.count, 0u);
  EXPECT_TRUE(std::isnan(left_out.all().plain.root_mean_square()));
}

// Against a look at every other gauge, with so many silent that the nearest kept do not always do.
TEST(LeftOutReadings, are_those_of_a_look_at_all) {
  Seeded seeded;
  std::vector<Station> stations;
  for (int i = 0; i < 80; ++i) {
    stations.push_back({std::to_string(i), {seeded.uniform(0, 10), seeded.uniform(0, 10)}});
  }
  const Network network(stations, Metric::planar);
  LeftOutReadings left_out(network, Metric::planar, nullptr, ElevationBands({}));
  ErrorSums expected;
  for (int step = 0; step < 40; ++step) {
    std::vector<double> readings;
    const double share = seeded.uniform(0, 1);
    for (int i = 0; i < 80; ++i)
      readings.push_back(seeded.uniform(0, 1) < share ? silent : seeded.uniform(0, 9));
    left_out.add(readings, {});
    for (std::size_t i = 0; i < 80; ++i) {
      double least = HUGE_VAL;
      std::size_t nearest = i;
      for (std::size_t j = 0; j < 80; ++j) {
        const double distance = std::hypot(stations[i].position.x - stations[j].position.x,
                                           stations[i].position.y - stations[j].position.y);
        if (j == i || std::isnan(readings[j]) || distance >= least) continue;
        least = distance;
        nearest = j;
      }
      if (!std::isnan(readings[i]) && nearest != i) expected.add(readings[nearest] - readings[i]);
    }
  }
  EXPECT_EQ(left_out.all().plain.count, expected.count);
  EXPECT_NEAR(left_out.all().plain.squares, expected.squares, 1e-9 * expected.squares);
}

}  // namespace
}  // namespace thiessen

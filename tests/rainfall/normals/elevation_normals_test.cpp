#include "rainfall/normals/elevation_normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

TEST(ElevationNormals, are_of_the_ground_of_the_gauge_and_of_the_others) {
  // Twelve gauges in a row, the last two at one place; rain doubles with each 1,000 m.
  std::vector<Station> stations;
  std::vector<Point> places;
  std::vector<double> elevations;
  std::vector<std::vector<double>> normals(1);
  for (int i = 0; i < 13; ++i) {
    const double x = i < 12 ? i : 11;
    stations.push_back({std::to_string(i), {x, 0}, 0});
    if (i == 12) break;
    places.push_back({x, 0});
    elevations.push_back(i % 2 == 0 ? 1000 : 200 + 100.0 * i);
    normals[0].push_back(600 * std::exp2(elevations.back() / 1000));
  }
  const Network network(stations, Metric::planar);
  const auto fit =
      std::make_shared<const ElevationFit>(places, elevations, normals, Metric::planar, 1);
  const auto ground = std::make_shared<const UniformNormals>(
      normals_at_stations(*fit, network), std::vector<std::vector<double>>{{700}});
  const std::vector<std::vector<double>> variances{{0.04}};
  const ElevationNormals field(fit, network, ground, variances);
  EXPECT_EQ(field.months(), 1);
  EXPECT_NEAR(field.at_gauge(StationIndex{4}, 0), 1200, 1e-9);
  EXPECT_EQ(field.at_gauge(StationIndex{12}, 0), field.at_gauge(StationIndex{11}, 0));
  EXPECT_NEAR(field.without(StationIndex{4}, 0), 1200, 1e-3);
  EXPECT_EQ(field.without(StationIndex{12}, 0), fit->without(11, 0));
  EXPECT_EQ(field.in(0).whole(0).mean, 700);
  EXPECT_TRUE(field.in(0).is_uniform());
  EXPECT_EQ(field.in(0).log_variance(0), 0.04);
}

}  // namespace
}  // namespace thiessen

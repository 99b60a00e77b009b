// Methods other than cells make a surface of readings relative to normals, times the normal.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "rainfall/gaps/gappy_study.h"
#include "rainfall/methods/basin_points.h"
#include "rainfall/methods/rain_methods.h"
#include "rainfall/normals/plane_raster.h"
#include "rainfall/normals/uniform_normals.h"

namespace thiessen {
namespace {

const std::vector<RainMethod> every_method{RainMethod::thiessen, RainMethod::arithmetic,
                                           RainMethod::idw, RainMethod::natural,
                                           RainMethod::isohyetal};

std::unique_ptr<const StepRainfall> by_every_method(const Weighing& weighing) {
  Warnings warnings;
  return rainfall_by(every_method, weighing, {.points = 300}, {}, 1, warnings);
}

// Basins that have twice the normal of every gauge have twice the rainfall; isohyets have other
// levels then, and are told apart from the others.
TEST(NormalsInMethods, of_basins_scale_their_values) {
  Seeded seeded;
  const gappy::Study plain = gappy::random_study(seeded);
  gappy::Study doubled{plain.network.stations(), plain.basins};
  doubled.weighing.take_normals(std::make_shared<const UniformNormals>(
      std::vector<std::vector<double>>(plain.network.stations().size(), {3.5}),
      std::vector<std::vector<double>>(plain.basins.size(), {7})));
  const auto readings = gappy::readings_of(seeded, plain, 0.2);
  const auto expected = by_every_method(plain.weighing)->at(readings);
  const auto found = by_every_method(doubled.weighing)->at(readings);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (std::isnan(expected[i].rainfall)) continue;
    const bool is_isohyetal = i % every_method.size() == 4;
    EXPECT_NEAR(found[i].rainfall, 2 * expected[i].rainfall,
                (is_isohyetal ? 0.05 : 1e-12) * expected[i].rainfall);
  }
}

// With one gauge every surface is flat: the value is the reading times the mean normal over the
// points, divided by the gauge's.
TEST(NormalsInMethods, of_one_gauge_are_the_mean_over_the_points) {
  const plane_raster::Raster raster{6, 6,
                                    [](double x, double y, std::size_t) { return 10 + x * y; }};
  gappy::Study study{{{"a", {2.5, 3.5}, 0}},
                     {shapes::basin({{shapes::rectangle({1, 1}, {5, 4}), {}}})}};
  study.weighing.take_normals(plane_raster::normals_of(raster, study.network, study.basins));
  const auto points = basin_points(study.basins[0], study.weighing.yardstick(), 300);
  double mean = 0;
  for (const Point p : points) mean += plane_raster::value_at(raster, p, 0) / 300;
  const auto rainfall = by_every_method(study.weighing);
  const auto found = rainfall->at(std::vector<double>{8});
  EXPECT_NEAR(found[2].rainfall, 8 * mean / 16, 1e-12);
  EXPECT_NEAR(found[3].rainfall, 8 * mean / 16, 1e-12);
  // x from 1 to 4 and y from 1 to 3: the mean of x is 2.5 and of y 2
  EXPECT_NEAR(found[0].rainfall, 8 * 15.0 / 16, 1e-12);
  EXPECT_NEAR(found[1].rainfall, 8 * 15.0 / 16, 1e-12);
  const auto weights = rainfall->weights_at(std::vector<double>{8});
  EXPECT_NEAR(weights[2].stations[0].factor, mean / 16, 1e-12);
}

}  // namespace
}  // namespace thiessen

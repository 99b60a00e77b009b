#include "files/normals/fitted_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "files/normals/mountain_study.h"

namespace thiessen {
namespace {

/// Normals that grow by 4e-4 for each unit of elevation from 50 at 0, at all gauges exactly.
ElevationFit exact_fit(const MountainStudy& given) {
  std::vector<double> elevations;
  std::vector<std::vector<double>> normals(1);
  for (const Station& station : given.study->network().stations()) {
    elevations.push_back(given.files->station_elevations.at(station.id));
    normals[0].push_back(50 * std::exp(4e-4 * elevations.back()));
  }
  return {given.study->network().places(), elevations, normals, Metric::planar, 1};
}

/// The mean of the pixels' normals, each pixel a 64th of the basin.
double mean_of_pixels(double scale) {
  double sum = 0;
  for (double x = 0.5; x < 8; ++x) {
    for (double y = 0.5; y < 8; ++y)
      sum += 50 * std::exp(4e-4 * scale * MountainStudy::ground(x, y)) / 64;
  }
  return sum;
}

TEST(FittedGround, has_the_normal_of_each_pixels_elevation) {
  MountainStudy given;
  const Study& study = given.made();
  const ElevationFit fit = exact_fit(given);
  const RasterGround ground(given.raster(), study, *given.files, given.warnings);
  const FittedGround found = normals_of_elevations(fit, ground, 1, study, 1, given.warnings);
  EXPECT_NEAR(found.normals->in(0).whole(0).mean, mean_of_pixels(1), 1e-4);
  EXPECT_EQ(found.normals->in(0).whole(0).covered, 1);
  EXPECT_NEAR(found.normals->in(0).at({6.3, 2.9}, 0),
              50 * std::exp(4e-4 * MountainStudy::ground(6.5, 2.5)), 1e-4);
  EXPECT_NEAR(found.normals->at_gauge(StationIndex{3}, 0), fit.at_place(3, 0), 1e-9);
  ASSERT_EQ(found.log_variances.size(), 1u);
  EXPECT_GE(found.log_variances[0].at(0), 0);
  EXPECT_LT(found.log_variances[0].at(0), 1e-6) << "elevation tells all";
  EXPECT_TRUE(given.notices().empty());
}

TEST(FittedGround, multiplies_the_rasters_values_by_a_scale) {
  MountainStudy given;
  const Study& study = given.made();
  const ElevationFit fit = exact_fit(given);
  const RasterGround ground(
      given.raster([](double x, double y) { return 2 * MountainStudy::ground(x, y); }), study,
      *given.files, given.warnings);
  const FittedGround found = normals_of_elevations(fit, ground, 0.25, study, 1, given.warnings);
  EXPECT_NEAR(found.normals->in(0).whole(0).mean, mean_of_pixels(0.5), 1e-4);
}

TEST(FittedGround, of_many_pixels_is_that_of_their_blocks) {
  // 640 pixels along a side are more than 128: blocks of two stand for them.
  MountainStudy given;
  const Study& study = given.made();
  const ElevationFit fit = exact_fit(given);
  const auto rough = [](double x, double y) {
    return std::round(MountainStudy::ground(x, y) + 80 * std::sin(300 * x) * std::sin(200 * y));
  };
  constexpr int pixels = 640;
  const RasterGround ground(given.raster(rough, "dem.asc", pixels), study, *given.files,
                            given.warnings);
  Complaints none;
  RasterFrame frame = *ground.frame_of(0, none);
  ground.set_blocks(frame, 100, 1.5);
  EXPECT_EQ(frame.block_columns, 5u);
  EXPECT_EQ(frame.block_rows, 1u);
  EXPECT_EQ(frame.window_columns(), 128u);
  const FittedGround found = normals_of_elevations(fit, ground, 1, study, 1, given.warnings);
  double sum = 0;
  for (int i = 0; i < pixels; ++i) {
    for (int j = 0; j < pixels; ++j)
      sum += 50 * std::exp(4e-4 * rough((i + 0.5) / 80, (j + 0.5) / 80));
  }
  const double mean = sum / (pixels * pixels);
  EXPECT_NEAR(found.normals->in(0).whole(0).mean, mean, 2e-6 * mean);
}

TEST(FittedGround, without_elevations_has_no_normals) {
  MountainStudy given;
  const Study& study = given.made();
  const ElevationFit fit = exact_fit(given);
  const RasterGround ground(
      given.raster([](double x, double y) { return y > 4 ? -9999 : MountainStudy::ground(x, y); }),
      study, *given.files, given.warnings);
  const FittedGround found = normals_of_elevations(fit, ground, 1, study, 1, given.warnings);
  EXPECT_DOUBLE_EQ(found.normals->in(0).whole(0).covered, 0.5);
  ASSERT_EQ(given.warnings.messages().size(), 1u);
  EXPECT_EQ(given.warnings.messages()[0].text.plain(),
            "has no elevations on 50.0 % of basin 'B'; ground without them takes the mean of the "
            "rest of what its gauge has");
}

TEST(FittedGround, is_held_by_the_nearest_gauge) {
  // A summit of 100,000 in a quarter of the ground: e to the 40th of the sea's.
  MountainStudy given;
  const Study& study = given.made();
  const ElevationFit fit = exact_fit(given);
  const RasterGround ground(given.raster([](double x, double y) {
    return x > 4 && y > 4 ? 100000 : MountainStudy::ground(x, y);
  }),
                            study, *given.files, given.warnings);
  const FittedGround found = normals_of_elevations(fit, ground, 1, study, 1, given.warnings);
  const double highest = 50 * std::exp(4e-4 * 1900);
  EXPECT_LT(found.normals->in(0).at({6.5, 6.5}, 0), 4 * highest);
  ASSERT_EQ(given.notices().size(), 1u);
  EXPECT_EQ(given.notices()[0],
            "normals fitted by elevation are held within a quarter and four times the nearest "
            "gauge's, which they exceed on 25.0 % of basin 'B'");
}

TEST(FittedGround, of_a_mean_elevation_is_one_normal) {
  MountainStudy given;
  const Study& study = given.made();
  const ElevationFit fit = exact_fit(given);
  const FittedGround found =
      normals_of_mean_elevations(fit, study, *given.files, 1, given.warnings);
  EXPECT_TRUE(found.normals->in(0).is_uniform());
  EXPECT_NEAR(found.normals->in(0).whole(0).mean, 50 * std::exp(0.4), 1e-4);
  EXPECT_TRUE(given.notices().empty());
  given.files->basin_elevations.clear();
  EXPECT_EQ(MountainStudy::faults_of(
                [&] { normals_of_mean_elevations(fit, study, *given.files, 1, given.warnings); }),
            std::vector<std::string>{"basin 'B' has no elevation"});
}

}  // namespace
}  // namespace thiessen

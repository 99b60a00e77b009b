#include "files/normals/raster_ground.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "files/normals/mountain_study.h"

namespace thiessen {
namespace {

TEST(RasterGround, knows_pixels_under_gauges_and_basins) {
  MountainStudy given;
  const Study& study = given.made();
  const RasterGround ground(given.raster(), study, *given.files, given.warnings);
  EXPECT_EQ(ground.at_stations()[0], std::vector<double>{MountainStudy::ground(1.5, 0.5)});
  EXPECT_EQ(ground.to_pixels({{3, 7}})[0], (Point{3, 1}));
  EXPECT_EQ(ground.to_study({{3, 1}})[0], (Point{3, 7}));
  EXPECT_EQ(ground.place_of(0), "basin 'B'");
  Complaints complaints;
  const std::optional<RasterFrame> frame = ground.frame_of(0, complaints);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->columns.count(), 8);
  EXPECT_TRUE(frame->holds_all());
  EXPECT_EQ(ground.values_of(*frame).at(0, 7, 1), MountainStudy::ground(1.5, 0.5));
  WindowValues rows(8, 2, 1, true);
  ground.read(*frame, 6, rows);
  EXPECT_EQ(rows.at(0, 1, 1), MountainStudy::ground(1.5, 0.5));
}

TEST(RasterGround, measures_the_share_of_marked_ground_block_by_block) {
  MountainStudy given;
  const Study& study = given.made();
  const RasterGround ground(given.raster(MountainStudy::ground, "dem.asc", 300), study,
                            *given.files, given.warnings);
  Complaints complaints;
  RasterFrame frame = *ground.frame_of(0, complaints);
  ground.set_blocks(frame, 100, 100);
  ASSERT_EQ(frame.block_columns, 2u);
  ASSERT_EQ(frame.window_rows(), 150u);
  WindowValues marks(150, 150, 1, false);
  for (std::size_t row = 0; row < 150; ++row) {
    for (std::size_t column = 0; column < 50; ++column) marks.set(0, row, column, 1);
  }
  EXPECT_NEAR(ground.share_of(0, frame, std::move(marks)), 1.0 / 3, 1e-12);
}

TEST(RasterGround, complains_of_a_basin_beyond_it) {
  MountainStudy given;
  const Study& study = given.made();
  const std::string raster = given.folder.write(
      "away.asc", "ncols 1\nnrows 1\nxllcorner 90\nyllcorner 90\ncellsize 1\n5\n");
  const RasterGround ground(raster, study, *given.files, given.warnings);
  EXPECT_TRUE(std::isnan(ground.at_stations()[0].front()));
  EXPECT_EQ(MountainStudy::faults_of([&] {
              Complaints complaints;
              EXPECT_FALSE(ground.frame_of(0, complaints));
              complaints.throw_if_any();
            }),
            std::vector<std::string>{"does not reach basin 'B'"});
}

}  // namespace
}  // namespace thiessen

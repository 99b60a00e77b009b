#include "cli/outputs/picture_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cli/outputs/cell_features.h"
#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

Picture picture(const GivenInputs& given, const GaugeReadings* readings,
                const ViewOptions& view = {}) {
  return picture_of(given.inputs, cells_of(given.inputs, readings, 1), readings, given.options(),
                    view);
}

TEST(PictureOf, a_network_is_by_station) {
  const Picture shown = picture(GivenInputs(), nullptr);
  EXPECT_FALSE(shown.by_rainfall);
  EXPECT_EQ(shown.title, "Thiessen cells");
  EXPECT_EQ(shown.subtitle, "");
  ASSERT_EQ(shown.gauges.size(), 2U);
  EXPECT_EQ(shown.gauges[1].label, "B");
  EXPECT_EQ(shown.gauges[1].position, (Point{8, 2}));
  EXPECT_TRUE(shown.gauges[1].reports);
  ASSERT_EQ(shown.cells.size(), 2U);
  EXPECT_EQ(shown.cells[1].gauge, 1U);
  EXPECT_TRUE(std::isnan(shown.cells[1].rainfall));
  ASSERT_EQ(shown.basins.size(), 1U);
  EXPECT_EQ(shown.basins[0].name, "Q");
}

TEST(PictureOf, readings_are_by_rainfall_and_silent_gauges_are_hollow) {
  const GaugeReadings readings{{std::nan(""), 12.5}, "2013-08-01"};
  const Picture shown = picture(GivenInputs(), &readings);
  EXPECT_TRUE(shown.by_rainfall);
  EXPECT_EQ(shown.title, "Rainfall by Thiessen cells");
  EXPECT_EQ(shown.subtitle, "2013-08-01");
  EXPECT_EQ(shown.units, "mm");
  EXPECT_FALSE(shown.gauges.at(0).reports);
  EXPECT_TRUE(shown.gauges.at(1).reports);
  ASSERT_EQ(shown.cells.size(), 1U);
  EXPECT_EQ(shown.cells[0].gauge, 1U);
  EXPECT_EQ(shown.cells[0].rainfall, 12.5);
}

TEST(PictureOf, what_the_options_say_goes_before) {
  ViewOptions view;
  view.title = "Mine";
  view.units = "in";
  view.size = {800, 600, false};
  const Picture shown = picture(GivenInputs(), nullptr, view);
  EXPECT_EQ(shown.title, "Mine");
  EXPECT_EQ(shown.units, "in");
  EXPECT_EQ(shown.width, 800);
  EXPECT_EQ(shown.height, 600);
}

// UTM's grid is north up at its central meridian, and EPSG:3031, about the south pole, is turned
// over at 180 degrees, which lies below the pole there.
TEST(PictureOf, a_size_in_mm_stays_known_as_it_was_given) {
  ViewOptions view;
  view.size = {297, 210, true};
  const Picture shown = picture(GivenInputs(), nullptr, view);
  EXPECT_EQ(shown.width, 3508) << "297 / 25.4 * 300 is 3507.9";
  EXPECT_EQ(shown.paper.width, 297);
  EXPECT_EQ(shown.paper.height, 210);
  EXPECT_EQ(picture(GivenInputs(), nullptr).paper.width, 0);
}

TEST(PictureOf, the_plane_says_its_unit_and_whether_north_is_up) {
  const Picture nowhere = picture(GivenInputs(), nullptr);
  EXPECT_FALSE(nowhere.geographic);
  EXPECT_TRUE(std::isnan(nowhere.metres_per_unit));
  EXPECT_TRUE(nowhere.north_is_up);
  const Picture utm = picture(GivenInputs(files_in_utm()), nullptr);
  EXPECT_FALSE(utm.geographic);
  EXPECT_EQ(utm.metres_per_unit, 1);
  EXPECT_TRUE(utm.north_is_up);
  GivenFiles antarctic = {
      "id,x,y\nA,0,-1500000\nB,1000,-1500500\n",
      "id,WKT\nQ,\"POLYGON ((0 -1501000,1000 -1501000,1000 -1500000,0 -1500000,0 -1501000))\"\n",
      {"--metric", "planar", "--crs", "EPSG:3031", "--basins-crs", "EPSG:3031"}};
  EXPECT_FALSE(picture(GivenInputs(antarctic), nullptr).north_is_up);
  const Picture degrees = picture(GivenInputs(files_in_degrees()), nullptr);
  EXPECT_TRUE(degrees.geographic);
  EXPECT_TRUE(degrees.north_is_up);
}

TEST(PictureOf, a_study_area_has_no_name) {
  GivenFiles files;
  files.basins.clear();
  files.stations = "id,x,y\nA,0,0\nB,8,2\n";
  EXPECT_EQ(picture(GivenInputs(files), nullptr).basins.at(0).name, "");
}

}  // namespace
}  // namespace thiessen::cli

#include "cli/checks/plane_report.h"

#include <gtest/gtest.h>

#include <string>

#include "cli/outputs/given_inputs.h"

namespace thiessen::cli {
namespace {

TEST(PlaneReport, is_empty_where_there_is_no_plane_of_the_earth) {
  EXPECT_EQ(describe_plane(GivenInputs().inputs), "");
  EXPECT_EQ(describe_plane(GivenInputs(files_in_degrees()).inputs), "");
}

// Along the central meridian of UTM areas are 0.9996 squared of the Earth's: 0.9992.
TEST(PlaneReport, names_the_plane_and_what_it_does) {
  const std::string text = describe_plane(GivenInputs(files_in_utm()).inputs);
  EXPECT_TRUE(text.starts_with("plane: EPSG:32633\nplane against the Earth: ")) << text;
  EXPECT_NE(text.find("0.9992"), std::string::npos) << text;
  EXPECT_TRUE(text.ends_with("\n"));
}

// Two kilometres about the meridian of 15 degrees are off by less than u^2/4, u = 1 km / 6,380 km:
// 6e-9.
TEST(PlaneReport, gives_the_definition_of_a_plane_that_was_made) {
  GivenFiles files = files_in_utm();
  files.options = {"--plane", "auto", "--crs", "EPSG:32633", "--basins-crs", "EPSG:32633"};
  const std::string text = describe_plane(GivenInputs(files).inputs);
  EXPECT_TRUE(text.starts_with("plane: +proj=")) << text;
  EXPECT_NE(text.find(", in which lengths are off by up to 0.00000"), std::string::npos) << text;
}

}  // namespace
}  // namespace thiessen::cli

#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(MapCommand, DeclaresOptionsUnderTheirHeadings) {
  EXPECT_EQ(group_of("map", "--resolution"), "Raster");
  EXPECT_EQ(group_of("map", "--title"), "Picture");
  EXPECT_EQ(group_of("map", "--overwrite"), "Output");
}

TEST(MapCommand, KnowsAMapByItsExtension) {
  for (const char* file : {"map.png", "map.JPG", "map.jpeg", "map.tif", "MAP.TIFF"})
    EXPECT_EQ(refusal({"map", "stations", "-o", file}), "");
  EXPECT_EQ(refusal({"map", "stations", "-o", "map"}),
            "a map is a .png, .jpg, .svg, .tif or .nc, not 'map'");
  EXPECT_EQ(refusal({"map", "stations"}), "-o map.png is missing");
}

TEST(MapCommand, ShowsATimeOfRainfallOnly) {
  EXPECT_EQ(refusal({"map", "s", "-o", "map.png", "--time", "2013"}), "--time needs RAINFALL");
}

}  // namespace
}  // namespace thiessen::cli

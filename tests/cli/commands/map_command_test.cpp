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

TEST(MapCommand, DrawsSurfacesAndIsohyetsInPictures) {
  for (const char* file : {"map.png", "map.svg"}) {
    EXPECT_EQ(refusal({"map", "s", "b", "r", "--method", "natural", "--isohyets", "--interval", "5",
                       "-o", file}),
              "");
  }
  EXPECT_EQ(refusal({"map", "s", "b", "r", "--interval", "5", "-o", "map.png"}),
            "--interval is the step between isohyets, and none are drawn");
  EXPECT_EQ(refusal({"map", "s", "b", "r", "--isohyets", "-o", "map.tif"}),
            "--isohyets is about pictures, and a raster is written");
  EXPECT_EQ(refusal({"map", "s", "-o", "map.png", "--method", "idw"}),
            "--method is about rainfall between gauges, and there is no RAINFALL");
}

TEST(MapCommand, ShowsSeveralTimesOnAPageAndNotInARaster) {
  const std::vector<std::string> times = {"map", "s", "b", "r", "--time", "1", "--time", "2", "-o"};
  const auto to = [&](const char* file) {
    std::vector<std::string> words = times;
    words.emplace_back(file);
    return refusal(words);
  };
  for (const char* file : {"map.png", "map.svg", "map.jpg"}) EXPECT_EQ(to(file), "");
  EXPECT_EQ(to("map.tif"), "several maps stand on a picture's page, and a raster is of one --time");
  EXPECT_NE(to("map.nc"), "");
  EXPECT_EQ(refusal({"cells", "s", "b", "r", "--time", "1", "--time", "2"}),
            "--time is given more than once");
}

}  // namespace
}  // namespace thiessen::cli

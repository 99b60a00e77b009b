#include <gtest/gtest.h>

#include <string>

#include "base/temporary_folder.h"
#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(TesselCommand, HasTwoDimensionsOrThree) {
  EXPECT_EQ(refusal({"tessel"}), "");
  EXPECT_EQ(refusal({"tessel", "--dim", "3", "script"}), "");
  EXPECT_EQ(refusal({"tessel", "--dim", "4"}), "--dim wants a whole number from 2 to 3, not '4'");
}

TEST(TesselCommand, KnowsNothingOfStations) {
  EXPECT_EQ(group_of("tessel", "--dim"), "General");
  EXPECT_EQ(refusal({"tessel", "--metric", "planar"}), "unknown option '--metric'");
}

// A PNG's width and height are its bytes 17 to 24.
TEST(TesselCommand, DrawsPicturesInThePlaneAndInSpace) {
  const TemporaryFolder folder;
  const std::string picture = folder.path("p.png");
  for (const std::string dimension : {"2", "3"}) {
    const std::string point = dimension == "2" ? "0 1" : "0 1 2";
    const std::string script =
        folder.write("script", "add " + point + "\nshow '" + picture + "' --size 400x300\n");
    ReadLine line({"tessel", "--dim", dimension, script});
    testing::internal::CaptureStdout();
    line.command->run(line.warnings);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    const std::string png = folder.read("p.png");
    EXPECT_EQ(png.substr(1, 3), "PNG") << dimension;
    EXPECT_EQ(png.substr(18, 2) + png.substr(22, 2), "\x01\x90\x01\x2c") << "400 by 300";
  }
}

}  // namespace
}  // namespace thiessen::cli

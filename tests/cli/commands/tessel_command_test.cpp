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

}  // namespace
}  // namespace thiessen::cli

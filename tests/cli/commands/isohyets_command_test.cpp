#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(IsohyetsCommand, DeclaresOptionsUnderTheirHeadings) {
  EXPECT_EQ(group_of("isohyets", "--method"), "Method");
  EXPECT_EQ(group_of("isohyets", "--interval"), "Method");
  EXPECT_EQ(group_of("isohyets", "--units"), "Readings");
}

TEST(IsohyetsCommand, WantsASurfaceAndOneWayToSayItsLevels) {
  EXPECT_EQ(refusal({"isohyets", "s", "b", "r"}), "");
  EXPECT_EQ(refusal({"isohyets", "s", "b", "r", "--method", "linear", "--breaks", "1,2.5"}), "");
  EXPECT_EQ(refusal({"isohyets", "s", "b", "r", "--method", "thiessen"}),
            "cells have no isohyets: rainfall jumps from one to the next");
  EXPECT_EQ(refusal({"isohyets", "s", "b", "r", "--interval", "5", "--breaks", "1,2"}),
            "--interval and --breaks both say the levels");
  EXPECT_EQ(refusal({"isohyets", "s", "b"}), "RAINFALL is missing");
}

}  // namespace
}  // namespace thiessen::cli

#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(CheckCommand, NeedsStationsAndWritesFindingsOfReadingsAlone) {
  EXPECT_EQ(refusal({"check"}), "STATIONS is missing");
  EXPECT_EQ(refusal({"check", "s", "b", "r", "--missing", "x"}), "");
  EXPECT_EQ(refusal({"check", "s", "b", "r", "-o", "file"}), "");
  EXPECT_EQ(refusal({"check", "s", "-o", "file"}),
            "--output is of findings in readings, and there is no RAINFALL");
}

TEST(CheckCommand, RefusesAPlaneThatIsGeodesic) {
  EXPECT_EQ(refusal({"check", "s", "--plane", "", "--metric", "geodesic"}),
            "--plane is planar, and --metric says geodesic");
}

TEST(CheckCommand, RefusesAnEmptyNameAsAFileThatCannotBeOpened) {
  EXPECT_THROW(ReadLine({"check", ""}), Error);
}

}  // namespace
}  // namespace thiessen::cli

#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

const std::vector<std::string> run{"run", "stations", "basins", "rainfall", "-o", "folder"};

std::vector<std::string> with(std::vector<std::string> line, const std::vector<std::string>& more) {
  line.insert(line.end(), more.begin(), more.end());
  return line;
}

TEST(RunCommand, NeedsFilesAndAFolder) {
  EXPECT_EQ(refusal({"run"}), "STATIONS, BASINS, RAINFALL and -o DIR are missing");
  EXPECT_EQ(refusal(run), "");
}

TEST(RunCommand, DeclaresOptionsUnderTheirHeadings) {
  EXPECT_EQ(group_of("run", "--gaps"), "Method");
  EXPECT_EQ(group_of("run", "--size"), "Picture");
  EXPECT_EQ(group_of("run", "--every"), "Output");
  EXPECT_EQ(group_of("run", "--time"), "");
}

TEST(RunCommand, WritesNoFolderToStandardOutput) {
  EXPECT_EQ(refusal({"run", "s", "b", "r", "-o", "-"}), "run writes a folder, not standard output");
}

TEST(RunCommand, RefusesTimesAndTotalsThatContradictEachOther) {
  EXPECT_EQ(refusal(with(run, {"--allow-missing", "2"})),
            "--allow-missing is about totals, and there is no --every");
  EXPECT_EQ(refusal(with(run, {"--allow-missing", "2", "--every", "month"})), "");
  EXPECT_EQ(refusal(with(run, {"--from", "2014", "--to", "2013-12"})),
            "--from 2014 is after --to 2013-12");
}

}  // namespace
}  // namespace thiessen::cli

#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

std::string refusal_with(const std::vector<std::string>& options) {
  std::vector<std::string> line{"rain", "stations", "basins", "rainfall"};
  line.insert(line.end(), options.begin(), options.end());
  return refusal(line);
}

TEST(RainCommand, DeclaresOptionsUnderTheirHeadings) {
  EXPECT_EQ(group_of("rain", "--method"), "Method");
  EXPECT_EQ(group_of("rain", "--error"), "Method");
  EXPECT_EQ(group_of("rain", "--weights-log"), "Output");
  EXPECT_EQ(group_of("rain", "--long"), "Output");
}

TEST(RainCommand, AveragesPointsByMethodsThatHavePoints) {
  EXPECT_EQ(refusal_with({"--grid", "500"}),
            "--grid is about --method idw, natural, isohyetal or all");
  EXPECT_EQ(refusal_with({"--grid", "500", "--method", "idw"}), "");
  EXPECT_EQ(refusal_with({"--grid", "500", "--method", "all"}), "");
}

TEST(RainCommand, KeepsTheAccountOfOneMethod) {
  EXPECT_EQ(refusal_with({"--method", "all", "--weights-log", "log.csv"}),
            "--weights-log is the account of one method, and --method says several");
  EXPECT_EQ(refusal_with({"--method", "idw", "--weights-log", "log.csv"}), "");
}

TEST(RainCommand, HasErrorsOfMethodsThatWeighGaugesFromAFile) {
  EXPECT_EQ(refusal_with({"--error"}), "");
  EXPECT_EQ(refusal_with({"--error", "--method", "isohyetal"}),
            "--error is of methods that weigh gauges, and isohyets do not");
  EXPECT_EQ(refusal_with({"--error", "--method", "idw"}), "");
  EXPECT_EQ(refusal_with({"--error", "--every", "day"}), "");
  EXPECT_EQ(refusal({"rain", "s", "b", "-", "--error"}),
            "--error reads RAINFALL twice, and standard input can be read once");
}

TEST(RainCommand, WritesWhatModelsRead) {
  EXPECT_EQ(group_of("rain", "--format"), "Output");
  EXPECT_EQ(refusal({"rain", "s", "b", "r", "--format", "hype"}), "");
  EXPECT_EQ(refusal({"rain", "s", "b", "r", "--stamp", "end", "--format", "hype"}), "");
  EXPECT_EQ(refusal({"rain", "s", "b", "r", "--format", "hype", "--error"}),
            "--error is beside the values, and --format hype has no place for it");
}

}  // namespace
}  // namespace thiessen::cli

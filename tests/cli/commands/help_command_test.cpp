#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

TEST(HelpCommand, TellsOfEveryCommand) {
  const Commands commands("thiessen");
  for (const std::string& name : commands.names()) EXPECT_EQ(refusal({"help", name}), "");
  EXPECT_EQ(refusal({"help"}), "");
}

TEST(HelpCommand, KnowsNoOtherCommand) {
  EXPECT_EQ(refusal({"help", "wieghts"}), "there is no command 'wieghts'");
  EXPECT_EQ(refusal({"help", ""}), "there is no command ''");
}

TEST(HelpCommand, TellsOneThingAtATime) {
  const std::string text = "COMMAND, --manual and --completion ask for three things";
  EXPECT_EQ(refusal({"help", "rain", "--manual"}), text);
  EXPECT_EQ(refusal({"help", "--manual", "--completion", "zsh"}), text);
  EXPECT_EQ(refusal({"help", "--completion", "csh"}),
            "--completion wants bash, zsh or fish, not 'csh'");
}

}  // namespace
}  // namespace thiessen::cli

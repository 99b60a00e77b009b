#include "cli/command_line.h"

#include "cli/command_lines.h"

namespace thiessen::cli {
namespace {

UsageError error_of(const std::vector<std::string>& arguments) {
  try {
    const ReadLine line(arguments);
  } catch (const UsageError& error) {
    return error;
  }
  return {};
}

TEST(CommandLine, ChoosesACommandAndReadsItsOptions) {
  const ReadLine line({"--metric", "planar", "-q", "weights", "s", "--id=gauge", "b"});
  EXPECT_STREQ(line.command->name(), "weights");
  EXPECT_TRUE(line.command->quiet());
  EXPECT_EQ(line.option("--id").texts, std::vector<std::string>{"gauge"});
  EXPECT_EQ(line.option("BASINS").texts, std::vector<std::string>{"b"});
}

TEST(CommandLine, TellsAnUnknownCommandWithTheNearest) {
  EXPECT_EQ(error_of({}).text, "no command is given");
  const UsageError error = error_of({"wieghts", "--metric", "none"});
  EXPECT_EQ(error.text, "there is no command 'wieghts'");
  EXPECT_TRUE(error.hint.starts_with("did you mean 'weights'?")) << error.hint;
}

TEST(CommandLine, TellsAnUnknownOptionBeforeAllElse) {
  for (const std::vector<std::string>& line :
       {std::vector<std::string>{"rain", "--metrik", "planar"},
        {"rain", "--decimals", "x", "--metrik=planar"},
        {"--metrik", "planar", "rain", "s", "b", "r"},
        {"rain", "s", "b", "r", "too many", "--metrik"},
        {"rain", "--metrik", "planar", "-o"}}) {
    EXPECT_EQ(error_of(line).text, "unknown option '--metrik'");
    EXPECT_TRUE(error_of(line).hint.starts_with("did you mean '--metric'?"));
  }
}

TEST(CommandLine, NamesTheCommandsThatHaveAnOption) {
  EXPECT_TRUE(error_of({"weights", "--resolution", "5"})
                  .hint.starts_with("it is an option of map and isohyets;"));
}

TEST(CommandLine, SaysWhereTheHelpIs) {
  EXPECT_EQ(error_of({"weights", "s"}).hint,
            "thiessen weights --help shows the files, the options and an example");
  EXPECT_EQ(error_of({"rain", "s", "b"}).hint,
            "--value-field or --rainfall may stand in place of RAINFALL");
}

}  // namespace
}  // namespace thiessen::cli

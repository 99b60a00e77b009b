#include "cli/help/help.h"

#include <gtest/gtest.h>

#include <sstream>

#include "base/complaints.h"
#include "cli/commands/commands.h"

namespace thiessen::cli {
namespace {

class HelpTest : public testing::Test {
 protected:
  std::string help(const std::string& command) const {
    return help_on(commands, *commands.find(command));
  }
  const Commands commands{"./build/thiessen"};
};

TEST_F(HelpTest, law_1_tells_of_every_option_under_its_heading) {
  for (const auto& command : commands.all()) {
    const std::string text = help_on(commands, *command);
    for (const Option& option : command->options().options()) {
      const std::size_t heading = text.find("\n" + option.group + ":\n");
      ASSERT_NE(heading, std::string::npos) << option.group;
      const std::size_t end = text.find("\n\n", heading);
      EXPECT_TRUE(contains(text.substr(heading, end - heading), option.name))
          << command->name() << ' ' << option.name;
    }
  }
}

TEST_F(HelpTest, law_2_no_line_is_longer_than_80_characters_where_a_word_allows_it) {
  for (const auto& command : commands.all()) {
    const std::string text = help_on(commands, *command);
    std::istringstream lines(text.substr(0, text.find(command->notes() + "\nExample")));
    for (std::string line; std::getline(lines, line) && !line.starts_with("Example");) {
      const bool is_heading = line == text.substr(0, text.find('\n'));
      const bool is_one_word = line.find(' ', line.find_first_not_of(' ')) == std::string::npos;
      EXPECT_TRUE(line.size() <= 80 || is_heading || is_one_word || line.starts_with("Usage: "))
          << line;
      EXPECT_FALSE(line.ends_with(' ')) << line;
    }
  }
}

TEST_F(HelpTest, the_usage_line_has_arguments_and_what_is_required) {
  EXPECT_EQ(usage_of(*commands.find("rain")), "rain STATIONS BASINS RAINFALL [options]");
  EXPECT_EQ(usage_of(*commands.find("run")), "run STATIONS BASINS RAINFALL -o DIR [options]");
  EXPECT_EQ(usage_of(*commands.find("cells")), "cells STATIONS [BASINS] [RAINFALL] [options]");
}

TEST_F(HelpTest, begins_with_what_the_command_does_and_ends_with_an_example_that_runs) {
  const std::string text = help("map");
  EXPECT_TRUE(text.starts_with(
      "A picture (.png, .jpg, .svg), or a georeferenced raster (.tif, .nc)\n\nUsage: "
      "thiessen map "));
  EXPECT_TRUE(contains(text, "\nExample, in the folder of the clone:\n  ./build/thiessen map "));
  EXPECT_TRUE(text.ends_with("\n"));
}

TEST_F(HelpTest, of_a_session_has_its_commands) {
  EXPECT_TRUE(contains(help("tessel"), "Commands, one a line:\n  add X Y [Z] "));
}

TEST_F(HelpTest, on_the_program_lists_every_command) {
  const std::string text = help_on(commands);
  for (const std::string& name : commands.names())
    EXPECT_TRUE(contains(text, "\n  " + name + " ")) << name;
  EXPECT_TRUE(contains(text, "Usage: thiessen COMMAND FILES [options]"));
}

// What is run in place of the program may have any name.
TEST(Help, shows_the_programs_name_fit_for_a_terminal) {
  EXPECT_TRUE(contains(help_on(Commands("a\x1b[2Jb")), "  a\\x1b[2Jb run "));
}

}  // namespace
}  // namespace thiessen::cli

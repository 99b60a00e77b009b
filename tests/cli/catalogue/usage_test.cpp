#include "cli/catalogue/usage.h"

#include <gtest/gtest.h>

#include "base/complaints.h"
#include "cli/commands/commands.h"

namespace thiessen::cli {
namespace {

class Usage : public testing::Test {
 protected:
  UsageError unknown(const std::string& command, const std::string& option) const {
    return unknown_option(commands, commands.find(command), option);
  }
  const Commands commands{"thiessen"};
};

TEST_F(Usage, an_unknown_option_is_answered_with_the_nearest_of_the_command) {
  const UsageError error = unknown("rain", "--metrik");
  EXPECT_EQ(error.text, "unknown option '--metrik'");
  EXPECT_EQ(error.hint, "did you mean '--metric'? " + where_help_is(*commands.find("rain")));
}

TEST_F(Usage, an_option_of_other_commands_is_answered_with_these) {
  EXPECT_TRUE(
      unknown("weights", "--resolution").hint.starts_with("it is an option of map and isohyets;"));
  EXPECT_TRUE(
      unknown("tessel", "--time").hint.starts_with("it is an option of cells, map and isohyets;"));
}

TEST_F(Usage, without_a_command_the_options_of_all_are_compared) {
  const UsageError error = unknown_option(commands, nullptr, "--resolutoin");
  EXPECT_TRUE(error.hint.starts_with("did you mean '--resolution'? the commands are run, "));
}

TEST_F(Usage, an_option_like_none_is_answered_with_where_the_help_is) {
  EXPECT_EQ(unknown("rain", "--zzzzzzzzz").hint, where_help_is(*commands.find("rain")));
}

TEST_F(Usage, law_1_no_option_of_a_command_is_unknown_to_it_in_a_hint) {
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      if (option.is_argument() || option.name.size() < 5) continue;
      const UsageError error = unknown(command->name(), option.name + "x");
      EXPECT_TRUE(contains(error.hint, "'" + option.name + "'"))
          << command->name() << ' ' << option.name << ": " << error.hint;
    }
  }
}

TEST_F(Usage, an_unknown_command_is_answered_with_the_nearest_and_all) {
  const UsageError error = unknown_command(commands, "wieghts");
  EXPECT_EQ(error.text, "there is no command 'wieghts'");
  EXPECT_TRUE(error.hint.starts_with("did you mean 'weights'? the commands are run, cells, "));
  EXPECT_EQ(no_command(commands).text, "no command is given");
  EXPECT_TRUE(no_command(commands).hint.ends_with("thiessen --help says what they do"));
}

TEST_F(Usage, what_is_repeated_on_the_terminal_is_fit_for_it) {
  EXPECT_EQ(unknown("rain", "--a\x1b[2J").text, "unknown option '--a\\x1b[2J'");
  EXPECT_EQ(unknown_command(commands, "a\n").text, "there is no command 'a\\x0a'");
}

}  // namespace
}  // namespace thiessen::cli

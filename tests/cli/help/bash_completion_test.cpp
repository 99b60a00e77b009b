#include <gtest/gtest.h>

#include "base/complaints.h"
#include "cli/commands/commands.h"
#include "cli/help/completion.h"

namespace thiessen::cli {
namespace {

// What bash makes of the script is tested by bash itself: tests/golden/completion.
TEST(BashCompletion, law_1_knows_every_command_and_every_option) {
  const Commands commands("thiessen");
  const std::string script = bash_completion(commands);
  for (const auto& command : commands.all()) {
    const std::size_t branch = script.find("    " + std::string(command->name()) + ")\n");
    ASSERT_NE(branch, std::string::npos) << command->name();
    const std::size_t begin = script.find("options='", branch);
    const std::string words = script.substr(begin, script.find('\n', begin) - begin);
    for (const Option& option : command->options().options()) {
      if (option.is_argument()) continue;
      EXPECT_TRUE(contains(words, option.name)) << command->name() << ' ' << option.name;
      EXPECT_TRUE(contains(words, option.short_name())) << command->name() << ' ' << option.name;
    }
  }
}

TEST(BashCompletion, law_2_waits_for_a_value_after_options_that_take_one_and_after_no_other) {
  const Commands commands("thiessen");
  const std::string script = bash_completion(commands);
  const std::size_t end = script.find(") awaits_value=yes");
  const std::size_t begin = script.rfind('\n', end);
  const std::string pattern = " " + script.substr(begin, end - begin) + " ";
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      if (option.is_argument()) continue;
      EXPECT_EQ(contains(pattern, " " + option.name + " "), !option.is_flag()) << option.name;
    }
  }
}

TEST(BashCompletion, offers_choices_and_files) {
  const std::string script = bash_completion(Commands("thiessen"));
  EXPECT_TRUE(contains(script, "--metric) words='geodesic planar' ;;"));
  EXPECT_TRUE(contains(script, "--output | -o) files=-d ;;"));
}

}  // namespace
}  // namespace thiessen::cli

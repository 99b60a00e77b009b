#include "cli/help/completion.h"

#include <gtest/gtest.h>

#include "cli/commands/commands.h"

namespace thiessen::cli {
namespace {

TEST(Completion, quotes_as_a_shell_reads) {
  EXPECT_EQ(shell_quoted("the station's id", "'\\''"), "'the station'\\''s id'");
  EXPECT_EQ(shell_quoted("", "'\\''"), "''");
  EXPECT_EQ(shell_quoted("a \"$b\" `c`", "\\'"), "'a \"$b\" `c`'");
}

TEST(Completion, says_what_an_option_is_for_up_to_the_first_semicolon) {
  Option option;
  option.help = "the station's id; else found by name; or not";
  EXPECT_EQ(in_few_words(option), "the station's id");
  option.help = "a;b";
  EXPECT_EQ(in_few_words(option), "a;b");
}

TEST(Completion, law_1_every_build_makes_the_same_bytes) {
  for (const auto script : {bash_completion, zsh_completion, fish_completion})
    EXPECT_EQ(script(Commands("thiessen")), script(Commands("/elsewhere/thiessen")));
}

}  // namespace
}  // namespace thiessen::cli

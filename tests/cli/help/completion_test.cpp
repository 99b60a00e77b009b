#include "cli/help/completion.h"
#include "cli/commands/commands.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace thiessen::cli {
namespace {

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Completion, KnowsEveryCommandAndEveryOptionInEveryShell) {
  const Commands commands("thiessen");
  const std::string bash = bash_completion(commands);
  const std::string zsh = zsh_completion(commands);
  const std::string fish = fish_completion(commands);
  for (const auto& command : commands.all()) {
    const std::string name = command->name();
    EXPECT_TRUE(has(bash, "    " + name + ")\n"));
    EXPECT_TRUE(has(zsh, "        " + name + ")\n"));
    for (const Option& option : command->options().options()) {
      if (option.is_argument()) continue;
      EXPECT_TRUE(has(bash, option.name)) << option.name;
      EXPECT_TRUE(has(zsh, option.name)) << option.name;
      EXPECT_TRUE(
          has(fish, "__fish_seen_subcommand_from " + name + "' -l " + option.name.substr(2) + " "))
          << option.name;
    }
  }
}

TEST(Completion, OffersChoicesAndFiles) {
  const Commands commands("thiessen");
  EXPECT_TRUE(has(bash_completion(commands), "--metric) words='geodesic planar' ;;"));
  EXPECT_TRUE(has(bash_completion(commands), "--output | -o) files=-d ;;"));
  EXPECT_TRUE(has(zsh_completion(commands), ":geodesic|planar:(geodesic planar)'"));
  EXPECT_TRUE(has(zsh_completion(commands), "'1:STATIONS:_files'"));
  EXPECT_TRUE(has(zsh_completion(commands), "'2::BASINS:_files'"));
  EXPECT_TRUE(has(fish_completion(commands), " -l metric -x -a 'geodesic planar' "));
}

TEST(Completion, OffersOptionsThatMayBeRepeatedAgain) {
  const std::string zsh = zsh_completion(Commands("thiessen"));
  EXPECT_TRUE(has(zsh, "'*--missing=["));
  EXPECT_TRUE(has(zsh, "'--metric=["));
}

TEST(Completion, law_1_EveryLineHasItsQuotesClosed) {
  const Commands commands("thiessen");
  std::string zsh = zsh_completion(commands);
  for (std::size_t at = 0; (at = zsh.find("'\\''", at)) != std::string::npos;) zsh.erase(at, 4);
  std::string fish = fish_completion(commands);
  for (std::size_t at = 0; (at = fish.find("\\'", at)) != std::string::npos;) fish.erase(at, 2);
  for (const std::string& script : {zsh, fish}) {
    for (std::size_t at = 0; at < script.size();) {
      const std::size_t end = script.find('\n', at);
      const std::string line = script.substr(at, end - at);
      at = end + 1;
      if (line.starts_with('#')) continue;
      EXPECT_EQ(std::count(line.begin(), line.end(), '\'') % 2, 0) << line;
    }
  }
}

TEST(Completion, QuotesAsAShellReads) {
  EXPECT_EQ(shell_quoted("the station's id", "'\\''"), "'the station'\\''s id'");
  Option option;
  option.help = "the station's id; else found by name";
  EXPECT_EQ(in_few_words(option), "the station's id");
}

}  // namespace
}  // namespace thiessen::cli

#include <gtest/gtest.h>

#include <algorithm>

#include "base/complaints.h"
#include "cli/commands/commands.h"
#include "cli/help/completion.h"

namespace thiessen::cli {
namespace {

std::string script() {
  return fish_completion(Commands("thiessen"));
}

TEST(FishCompletion, law_1_knows_every_command_and_every_option) {
  const Commands commands("thiessen");
  const std::string text = script();
  for (const auto& command : commands.all()) {
    const std::string name = command->name();
    EXPECT_TRUE(contains(text, " -n __fish_use_subcommand -a " + name + " -d '")) << name;
    for (const Option& option : command->options().options()) {
      if (option.is_argument()) continue;
      EXPECT_TRUE(contains(
          text, "__fish_seen_subcommand_from " + name + "' -l " + option.name.substr(2) + " "))
          << name << ' ' << option.name;
    }
  }
}

TEST(FishCompletion, law_2_every_line_has_its_quotes_closed) {
  std::string text = script();
  for (std::size_t at = 0; (at = text.find("\\'", at)) != std::string::npos;) text.erase(at, 2);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('#')) continue;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\'') % 2, 0) << line;
    EXPECT_TRUE(line.starts_with("complete -c thiessen ")) << line;
  }
}

TEST(FishCompletion, offers_choices_files_and_folders) {
  EXPECT_TRUE(contains(script(), " -l metric -x -a 'geodesic planar' "));
  EXPECT_TRUE(contains(script(), " -l output -s o -r -F "));
  EXPECT_TRUE(contains(script(), " -l output -s o -x -a '(__fish_complete_directories)' "));
  EXPECT_TRUE(contains(script(), " -l quiet -s q -d '")) << "a flag takes no value";
}

}  // namespace
}  // namespace thiessen::cli

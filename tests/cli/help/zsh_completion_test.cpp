#include <gtest/gtest.h>

#include <algorithm>

#include "base/complaints.h"
#include "cli/commands/commands.h"
#include "cli/help/completion.h"

namespace thiessen::cli {
namespace {

std::string script() {
  return zsh_completion(Commands("thiessen"));
}

TEST(ZshCompletion, law_1_knows_every_command_and_every_option) {
  const Commands commands("thiessen");
  const std::string text = script();
  for (const auto& command : commands.all()) {
    const std::size_t begin = text.find("        " + std::string(command->name()) + ")\n");
    ASSERT_NE(begin, std::string::npos) << command->name();
    const std::string branch = text.substr(begin, text.find(";;", begin) - begin);
    for (const Option& option : command->options().options()) {
      if (option.is_argument()) continue;
      const std::string sign = option.is_flag() ? "[" : "=[";
      EXPECT_TRUE(contains(branch, option.name + sign)) << command->name() << ' ' << option.name;
    }
  }
}

TEST(ZshCompletion, law_2_every_line_has_its_quotes_closed) {
  std::string text = script();
  for (std::size_t at = 0; (at = text.find("'\\''", at)) != std::string::npos;) text.erase(at, 4);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('#')) continue;
    EXPECT_EQ(std::count(line.begin(), line.end(), '\'') % 2, 0) << line;
  }
}

TEST(ZshCompletion, offers_choices_and_files_and_arguments_by_their_places) {
  EXPECT_TRUE(contains(script(), ":geodesic|planar:(geodesic planar)'"));
  EXPECT_TRUE(contains(script(), "'1:STATIONS:_files'"));
  EXPECT_TRUE(contains(script(), "'2::BASINS:_files'"));
  EXPECT_TRUE(contains(script(), ":_files -/'"));
}

TEST(ZshCompletion, offers_options_that_may_be_repeated_again) {
  EXPECT_TRUE(contains(script(), "'*--missing=["));
  EXPECT_TRUE(contains(script(), "'--metric=["));
}

// In a specification a colon and brackets part it.
TEST(ZshCompletion, escapes_signs_that_have_a_meaning_in_a_specification) {
  EXPECT_TRUE(contains(script(), "'run:everything in one folder\\: cells.geojson"));
}

}  // namespace
}  // namespace thiessen::cli

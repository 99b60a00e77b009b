#include "cli/commands/commands.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace thiessen::cli {
namespace {

TEST(Commands, law_1_AnOptionIsAFlagEverywhereOrNowhere) {
  const Commands commands("thiessen");
  std::map<std::string, bool> is_flag;
  std::map<std::string, char> letter;
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      EXPECT_EQ(is_flag.emplace(option.name, option.is_flag()).first->second, option.is_flag());
      EXPECT_EQ(letter.emplace(option.name, option.letter).first->second, option.letter);
    }
  }
}

TEST(Commands, law_2_ALetterIsOfOneOption) {
  const Commands commands("thiessen");
  std::map<char, std::string> name;
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      if (option.letter != '\0') {
        EXPECT_EQ(name.emplace(option.letter, option.name).first->second, option.name);
      }
    }
  }
}

TEST(Commands, law_3_EveryOptionSaysWhatItIsForUnderAHeading) {
  const Commands commands("thiessen");
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      EXPECT_FALSE(option.help.empty()) << option.name;
      EXPECT_FALSE(option.group.empty()) << option.name;
      EXPECT_TRUE(option.value.read) << option.name;
    }
  }
}

TEST(Commands, AllHaveHelpAndVersion) {
  const Commands commands("thiessen");
  for (const auto& command : commands.all()) {
    EXPECT_NE(command->options().find("-h"), nullptr) << command->name();
    EXPECT_NE(command->options().find("--version"), nullptr) << command->name();
  }
}

TEST(Commands, AreFoundByTheirNames) {
  const Commands commands("thiessen");
  EXPECT_STREQ(commands.find("rain")->name(), "rain");
  EXPECT_EQ(commands.find("rai"), nullptr);
}

}  // namespace
}  // namespace thiessen::cli

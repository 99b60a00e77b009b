#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cli/command_line.h"

namespace thiessen::cli {

/// A command line that is read and checked, and of which nothing is run. No file of it exists.
struct ReadLine {
  explicit ReadLine(const std::vector<std::string>& arguments)
      : line("thiessen"), command(line.parse(arguments, warnings)) {}

  const Option& option(const std::string& name) const { return *command->options().find(name); }

  CommandLine line;
  Warnings warnings;
  Command* command;
};

/// What is said of a command line that is refused; empty where it is not.
inline std::string refusal(const std::vector<std::string>& arguments) {
  try {
    const ReadLine line(arguments);
  } catch (const UsageError& error) {
    return error.text;
  }
  return {};
}

/// The heading under which the help on a command has the option; empty: nowhere.
inline std::string group_of(const std::string& command, const std::string& option) {
  const Commands commands("thiessen");
  const Option* found = commands.find(command)->options().find(option);
  return found == nullptr ? "" : found->group;
}

}  // namespace thiessen::cli

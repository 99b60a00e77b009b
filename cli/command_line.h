#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/commands/commands.h"

namespace thiessen::cli {

/// The command line, which chooses one of the commands.
class CommandLine {
 public:
  /// `program` is the name by which it was called, for examples that run.
  explicit CommandLine(std::string program) : commands_(std::move(program)) {}

  const Commands& commands() const { return commands_; }

  /// The command to run, with its options read and checked; none where the help or the version was
  /// all that was asked for, and is printed. Options may stand before the command too. Throws
  /// UsageError, of options and commands that do not exist first, and Error where the name of a
  /// file is empty. Is called once.
  Command* parse(std::vector<std::string> arguments);

 private:
  Commands commands_;
};

}  // namespace thiessen::cli

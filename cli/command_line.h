#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "cli/commands/commands.h"

namespace thiessen::cli {

/// The command line of the program, which chooses one of the commands.
class CommandLine {
 public:
  /// `program` is the name by which the program was called, so that examples in messages run.
  explicit CommandLine(std::string program) : commands_(std::move(program)) {}

  const Commands& commands() const { return commands_; }

  /// Reads and checks the options, and returns the command to run; none where only the help or the
  /// version was asked for, and is printed. Options may stand before the command too. Throws
  /// UsageError, for options and commands that do not exist before all else, and Error where the
  /// name of a file is empty. To be called once.
  Command* parse(std::vector<std::string> arguments, Warnings& warnings);

 private:
  Commands commands_;
};

}  // namespace thiessen::cli

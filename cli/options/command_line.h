#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands/command.h"

namespace thiessen::cli {

/// The commands, and the command line that chooses one of them.
class CommandLine {
 public:
  /// `program` is the name by which it was called, for examples that run.
  explicit CommandLine(const std::string& program);

  /// The command to run; none where the help or the version was all that was asked for, and is
  /// printed. Throws UsageError, and Error where the name of a file is empty.
  Command* parse(std::vector<std::string> arguments);

 private:
  void add(Command& command, const std::string& version, const std::string& example);
  void bring_command_forward(std::vector<std::string>& arguments) const;
  bool is_command(const std::string& text) const;
  bool takes_value(const std::string& option) const;
  void print(const CLI::Success& success) const;

  std::vector<std::unique_ptr<Command>> commands_;
  CLI::App app_;
};

}  // namespace thiessen::cli

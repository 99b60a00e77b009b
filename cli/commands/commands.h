#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/commands/command.h"

namespace thiessen::cli {

std::unique_ptr<Command> make_run_command();
std::unique_ptr<Command> make_cells_command();
std::unique_ptr<Command> make_weights_command();
std::unique_ptr<Command> make_rain_command();
std::unique_ptr<Command> make_map_command();
std::unique_ptr<Command> make_check_command();
std::unique_ptr<Command> make_tessel_command();

class Commands;
/// Makes the command `help`, which explains the given commands, itself included. They must outlive
/// it.
std::unique_ptr<Command> make_help_command(const Commands& commands);

/// All that the program offers: its commands, and the options that need no command.
class Commands {
 public:
  /// `program` is the name by which the program was called, so that examples in the help run.
  explicit Commands(std::string program);
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  const std::string& program() const { return program_; }

  /// The commands in the order of the help.
  const std::vector<std::unique_ptr<Command>>& all() const { return commands_; }
  /// The command of this name; nullptr where there is none.
  Command* find(const std::string& name) const;
  /// The options that may be given without a command.
  const OptionList& options() const { return options_; }
  std::vector<std::string> names() const;

 private:
  std::string program_;
  OptionList options_;
  std::vector<std::unique_ptr<Command>> commands_;
};

}  // namespace thiessen::cli

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
/// It tells of the commands, which must outlive it, and of itself.
std::unique_ptr<Command> make_help_command(const Commands& commands);

/// All that the program offers: the commands, and the options that need none.
class Commands {
 public:
  /// `program` is the name by which it was called, for examples that run.
  explicit Commands(std::string program);
  Commands(const Commands&) = delete;
  Commands& operator=(const Commands&) = delete;

  const std::string& program() const { return program_; }

  /// In the order of the help.
  const std::vector<std::unique_ptr<Command>>& all() const { return commands_; }
  /// None: nullptr.
  Command* find(const std::string& name) const;
  /// What may stand without a command.
  const OptionList& options() const { return options_; }
  std::vector<std::string> names() const;

 private:
  std::string program_;
  OptionList options_;
  std::vector<std::unique_ptr<Command>> commands_;
};

}  // namespace thiessen::cli

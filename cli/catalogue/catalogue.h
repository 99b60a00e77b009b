#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cli/catalogue/command.h"

namespace thiessen::cli {

/// All that the program offers: its commands, and the options that need no command. It knows no
/// command by name; cli/commands/commands.h fills it.
class Catalogue {
 public:
  /// `program` is the name by which the program was called, so that examples in the help run.
  explicit Catalogue(std::string program);
  Catalogue(const Catalogue&) = delete;
  Catalogue& operator=(const Catalogue&) = delete;

  const std::string& program() const { return program_; }

  /// Appends a command and gives it the options that all have.
  void add(std::unique_ptr<Command> command);
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

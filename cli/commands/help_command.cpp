#include <string>
#include <utility>

#include "base/file.h"
#include "cli/catalogue/usage.h"
#include "cli/commands/commands.h"
#include "cli/help/completion.h"
#include "cli/help/help.h"
#include "cli/help/manual.h"
#include "cli/options/option_values.h"

namespace thiessen::cli {
namespace {

enum class Shell { none, bash, zsh, fish };

class HelpCommand : public Command {
 public:
  explicit HelpCommand(const Catalogue& commands) : commands_(commands) {
    OptionValue command = any_text(command_, "");
    command.choices = commands.names();
    command.choices.emplace_back(name());
    options().group("Command").add("COMMAND", std::move(command),
                                   "what the help is wanted on; default: the program");
    OptionGroup forms = options().group("Other forms");
    forms.add("--manual", flag(wants_manual_), "the manual page thiessen.1, for man");
    forms.add(
        "--completion",
        choice<Shell>(shell_, {{"bash", Shell::bash}, {"zsh", Shell::zsh}, {"fish", Shell::fish}}),
        "a script with which the shell completes commands, options, values and files");
  }

  const char* name() const override { return "help"; }
  const char* description() const override {
    return "the help on a command; the manual; completion for bash, zsh and fish";
  }
  const char* example() const override { return "rain"; }

  void check() const override {
    const Option& command = *options().find("COMMAND");
    const int wanted =
        (command.is_given() ? 1 : 0) + (wants_manual_ ? 1 : 0) + (shell_ != Shell::none ? 1 : 0);
    if (wanted > 1) {
      throw UsageError{"COMMAND, --manual and --completion ask for three things",
                       "ask for one at a time"};
    }
    if (command.is_given() && commands_.find(command_) == nullptr)
      throw unknown_command(commands_, command_);
  }

  void run(Warnings&) override {
    OutputFile output = standard_output();
    output.append(text());
    output.finish();
  }
  bool quiet() const override { return false; }

 private:
  std::string text() const {
    if (wants_manual_) return manual(commands_);
    switch (shell_) {
      case Shell::none:
        break;
      case Shell::bash:
        return bash_completion(commands_);
      case Shell::zsh:
        return zsh_completion(commands_);
      case Shell::fish:
        return fish_completion(commands_);
    }
    return command_.empty() ? help_on(commands_) : help_on(commands_, *commands_.find(command_));
  }

  const Catalogue& commands_;
  std::string command_;
  bool wants_manual_ = false;
  Shell shell_ = Shell::none;
};

}  // namespace

std::unique_ptr<Command> make_help_command(const Catalogue& commands) {
  return std::make_unique<HelpCommand>(commands);
}

}  // namespace thiessen::cli

#include "cli/command_line.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "cli/catalogue/usage.h"
#include "cli/help/help.h"
#include "cli/help/versions.h"
#include "cli/options/arguments.h"
#include "cli/options/reading.h"

namespace thiessen::cli {
namespace {

bool says(const Arguments& said, const std::string& name) {
  return std::any_of(said.options.begin(), said.options.end(),
                     [&](const Arguments::Given& given) { return given.name == name; });
}

void print(const std::string& text) {
  OutputFile file = standard_output();
  file.append(text);
  file.finish();
}

std::vector<const OptionList*> lists_of(const Catalogue& commands) {
  std::vector<const OptionList*> lists{&commands.options()};
  for (const auto& command : commands.all()) lists.push_back(&command->options());
  return lists;
}

/// Throws UsageError for an option or a command that does not exist.
void refuse_unknown(const Catalogue& commands, const Command* command, const Arguments& said) {
  const OptionList& options = command == nullptr ? commands.options() : command->options();
  const std::string option = unknown_option(options, said);
  const bool is_nobodys = !said.unknown.empty();
  if (is_nobodys || (command != nullptr && !option.empty()))
    throw unknown_option(commands, command, option);
  if (command != nullptr) return;
  if (said.words.empty()) throw no_command(commands);
  throw unknown_command(commands, said.words.front());
}

}  // namespace

Command* CommandLine::parse(std::vector<std::string> arguments, Warnings& warnings) {
  const Arguments said = parse_arguments(std::move(arguments), lists_of(commands_));
  Command* command = said.words.empty() ? nullptr : commands_.find(said.words.front());
  const bool may_ask = command != nullptr || said.words.empty();
  if (may_ask && says(said, "--help")) {
    print(command == nullptr ? help_on(commands_) : help_on(commands_, *command));
    return nullptr;
  }
  if (may_ask && says(said, "--version")) {
    print(versions());
    return nullptr;
  }
  refuse_unknown(commands_, command, said);
  try {
    read_options(command->options(), said, warnings);
  } catch (UsageError& error) {
    if (error.hint.empty()) error.hint = where_help_is(*command);
    throw;
  }
  require_file_names(command->options());
  command->check();
  return command;
}

}  // namespace thiessen::cli

#include "cli/command_line.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "cli/help/help.h"
#include "cli/options/arguments.h"
#include "cli/options/reading.h"

namespace thiessen::cli {
namespace {

constexpr const char* version = "thiessen " THIESSEN_VERSION "\n";

bool says(const Arguments& said, const std::string& name) {
  return std::any_of(said.options.begin(), said.options.end(),
                     [&](const Arguments::Given& given) { return given.name == name; });
}

void print(const std::string& text) {
  OutputFile file = standard_output();
  file.append(text);
  file.finish();
}

std::vector<const OptionList*> lists_of(const Commands& commands) {
  std::vector<const OptionList*> lists{&commands.options()};
  for (const auto& command : commands.all()) lists.push_back(&command->options());
  return lists;
}

std::string list_of_commands(const Commands& commands) {
  std::string text;
  const std::vector<std::string> names = commands.names();
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  return "the commands are " + text + "; thiessen --help says what they do";
}

std::string where_help_is(const Command& command) {
  return std::string("thiessen ") + command.name() +
         " --help shows the files, the options and an example";
}

void refuse_unknown(const Commands& commands, const Command* command, const Arguments& said) {
  const OptionList& options = command == nullptr ? commands.options() : command->options();
  const std::string unknown = unknown_option(options, said);
  const bool is_nobodys = !said.unknown.empty();
  if (is_nobodys || (command != nullptr && !unknown.empty())) {
    throw UsageError{"unknown option '" + printable(unknown) + "'",
                     command == nullptr ? list_of_commands(commands) : where_help_is(*command)};
  }
  if (command != nullptr) return;
  throw UsageError{said.words.empty()
                       ? "no command is given"
                       : "there is no command '" + printable(said.words.front()) + "'",
                   list_of_commands(commands)};
}

}  // namespace

Command* CommandLine::parse(std::vector<std::string> arguments) {
  const Arguments said = parse_arguments(std::move(arguments), lists_of(commands_));
  Command* command = said.words.empty() ? nullptr : commands_.find(said.words.front());
  const bool may_ask = command != nullptr || said.words.empty();
  if (may_ask && says(said, "--help")) {
    print(command == nullptr ? help_on(commands_, program_) : help_on(*command, program_));
    return nullptr;
  }
  if (may_ask && says(said, "--version")) {
    print(version);
    return nullptr;
  }
  refuse_unknown(commands_, command, said);
  try {
    read_options(command->options(), said);
  } catch (UsageError& error) {
    error.hint = where_help_is(*command);
    throw;
  }
  require_file_names(command->options());
  command->check();
  return command;
}

}  // namespace thiessen::cli

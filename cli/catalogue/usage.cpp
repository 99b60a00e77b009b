#include "cli/catalogue/usage.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "cli/options/name_lists.h"
#include "text/similar_texts.h"

namespace thiessen::cli {
namespace {

std::string where_help_is(const Catalogue& commands) {
  return "the commands are " + and_list(commands.names()) + "; thiessen --help says what they do";
}

/// Adds the names of the options, but for those that are in the list already.
void add_names(const OptionList& options, std::vector<std::string>& names) {
  for (const Option& option : options.options()) {
    const bool is_there = std::find(names.begin(), names.end(), option.name) != names.end();
    if (!option.is_argument() && !is_there) names.push_back(option.name);
  }
}

std::vector<std::string> option_names(const Catalogue& commands, const Command* command) {
  std::vector<std::string> names;
  if (command != nullptr) {
    add_names(command->options(), names);
    return names;
  }
  add_names(commands.options(), names);
  for (const auto& any : commands.all()) add_names(any->options(), names);
  return names;
}

std::vector<std::string> commands_with(const Catalogue& commands, const std::string& option) {
  std::vector<std::string> names;
  for (const auto& command : commands.all()) {
    if (command->options().find(option) != nullptr) names.emplace_back(command->name());
  }
  return names;
}

/// Joins two parts of a hint, of which the first may be empty.
std::string hint(const std::string& first, const std::string& second) {
  return first + (first.empty() ? "" : " ") + second;
}

}  // namespace

std::string where_help_is(const Command& command) {
  return std::string("thiessen ") + command.name() +
         " --help shows the files, the options and an example";
}

UsageError unknown_option(const Catalogue& commands, const Command* command,
                          const std::string& option) {
  const std::string text = "unknown option '" + printable(option) + "'";
  const std::string nearest = did_you_mean(nearest_names(option, option_names(commands, command)));
  if (command == nullptr) return {text, hint(nearest, where_help_is(commands))};
  const std::vector<std::string> others = commands_with(commands, option);
  const std::string elsewhere =
      others.empty() ? "" : "it is an option of " + and_list(others) + ";";
  return {text, hint(others.empty() ? nearest : elsewhere, where_help_is(*command))};
}

UsageError unknown_command(const Catalogue& commands, const std::string& name) {
  return {"there is no command '" + printable(name) + "'",
          hint(did_you_mean(nearest_names(name, commands.names())), where_help_is(commands))};
}

UsageError no_command(const Catalogue& commands) {
  return {"no command is given", where_help_is(commands)};
}

}  // namespace thiessen::cli

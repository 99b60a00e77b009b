#include "cli/options/usage.h"

#include <string>
#include <vector>

#include "base/error.h"
#include "cli/options/help.h"

namespace thiessen::cli {
namespace {

template <typename Kind>
bool is(const CLI::ParseError& error) {
  return dynamic_cast<const Kind*>(&error) != nullptr;
}

std::string missing(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_required() || option->count() > 0) continue;
    const std::string value = option->get_positional() ? "" : " " + option->get_type_name();
    names.push_back(short_name(*option) + value);
  }
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 < names.size() ? ", " : " and ") + names[i];
  }
  return text + (names.size() == 1 ? " is missing" : " are missing");
}

/// The parser's own sentence begins with the option's name.
std::string wrong_count(const CLI::App& command, const std::string& text) {
  const CLI::Option* option = command.get_option_no_throw(text.substr(0, text.find(':')));
  if (option == nullptr) return printable(text);
  if (option->count() > 1) return short_name(*option) + " is given more than once";
  return short_name(*option) + " needs a value: " + value_of(*option);
}

std::string without_command(const std::vector<std::string>& extras) {
  if (extras.empty() || extras.front().starts_with('-')) return "no command is given";
  return "there is no command '" + printable(extras.front()) + "'";
}

std::string unexpected(const std::string& argument) {
  const bool is_option = argument.size() > 1 && argument[0] == '-';
  return (is_option ? "unknown option '" : "one file too many: '") + printable(argument) + "'";
}

std::string sentence(const CLI::App& command, const CLI::ParseError& error) {
  const std::vector<std::string> extras = command.remaining();
  if (is<CLI::ExtrasError>(error) && !extras.empty()) return unexpected(extras.front());
  if (is<CLI::RequiredError>(error)) return missing(command);
  if (is<CLI::ArgumentMismatch>(error)) return wrong_count(command, error.what());
  std::string text = error.what();
  const std::size_t colon = text.find(": ");
  if (colon != std::string::npos && text[0] == '-') text.erase(colon, 1);
  return printable(text);
}

}  // namespace

UsageError usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  if (used.empty()) {
    return {
        without_command(app.remaining()),
        "the commands are run, cells, weights, rain, map, check and tessel; thiessen --help says "
        "what they do"};
  }
  return {sentence(*used.front(), error),
          "thiessen " + used.front()->get_name() +
              " --help shows the files, the options and an example"};
}

}  // namespace thiessen::cli

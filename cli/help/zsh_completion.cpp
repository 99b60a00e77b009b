#include <stdexcept>
#include <string_view>

#include "cli/help/completion.h"

namespace thiessen::cli {
namespace {

constexpr const char* quote = "'\\''";

constexpr const char* beginning = R"(#compdef thiessen
# Completion of thiessen's command lines in zsh.
_thiessen() {
  local curcontext="$curcontext" state line
  typeset -A opt_args
  local -a commands
  commands=(
)";

/// Escapes the signs that have a meaning in a specification of _arguments or _describe.
std::string escaped(const std::string& text) {
  constexpr std::string_view signs = "\\[]:";
  std::string result;
  for (const char c : text) {
    if (signs.find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

/// The part of a specification that completes a value: `:KIND:(a b)`.
std::string action(const std::string& kind, const OptionValue& value) {
  std::string message = ":" + escaped(kind) + ":";
  if (!value.choices.empty()) {
    std::string words;
    for (const std::string& choice : value.choices) words += (words.empty() ? "" : " ") + choice;
    return message + "(" + words + ")";
  }
  switch (value.completion) {
    case Completion::nothing:
      return message + " ";
    case Completion::file:
      return message + "_files";
    case Completion::folder:
      return message + "_files -/";
  }
  throw std::logic_error("not a completion");
}

/// The specifications of an option for _arguments, one for each spelling.
std::string specifications(const Option& option, const std::string& margin) {
  const std::string repeated = option.value.may_be_repeated ? "*" : "";
  const std::string rest = "[" + escaped(in_few_words(option)) + "]" +
                           (option.is_flag() ? "" : action(option.value.kind, option.value));
  const std::string sign = option.is_flag() ? "" : "=";
  std::string text = margin + shell_quoted(repeated + option.name + sign + rest, quote) + " \\\n";
  if (option.letter != '\0') {
    const std::string short_sign = option.is_flag() ? "" : "+";
    text +=
        margin + shell_quoted(repeated + option.short_name() + short_sign + rest, quote) + " \\\n";
  }
  return text;
}

std::string arguments_of(const OptionList& options, const std::string& margin) {
  std::string text;
  std::size_t place = 0;
  for (const Option& option : options.options()) {
    if (!option.is_argument()) {
      text += specifications(option, margin);
      continue;
    }
    const std::string optional = option.need == Need::optional ? ":" : "";
    text += margin +
            shell_quoted(std::to_string(++place) + optional + action(option.name, option.value),
                         quote) +
            " \\\n";
  }
  return text;
}

std::string branch_of(const Command& command) {
  return "        " + std::string(command.name()) + ")\n          _arguments -s \\\n" +
         arguments_of(command.options(), "            ") +
         "            && return 0\n          ;;\n";
}

}  // namespace

std::string zsh_completion(const Catalogue& commands) {
  std::string text = beginning;
  for (const auto& command : commands.all()) {
    text += "    " +
            shell_quoted(command->name() + (":" + escaped(command->description())), quote) + "\n";
  }
  text += "  )\n  _arguments -C \\\n" + arguments_of(commands.options(), "    ") +
          "    '1: :->command' \\\n    '*:: :->arguments' && return 0\n"
          "  case $state in\n    command) _describe -t commands 'thiessen command' commands ;;\n"
          "    arguments)\n      case $line[1] in\n";
  for (const auto& command : commands.all()) text += branch_of(*command);
  return text +
         "      esac\n      ;;\n  esac\n}\n"
         "# Read by source, it is registered; in a folder of fpath, it is the function itself.\n"
         "if [[ $funcstack[1] == _thiessen ]]; then _thiessen \"$@\"; else compdef _thiessen "
         "thiessen; fi\n";
}

}  // namespace thiessen::cli

#include "cli/help/completion.h"

#include <stdexcept>

namespace thiessen::cli {
namespace {

constexpr const char* quote = "\\'";
constexpr const char* line = "complete -c thiessen";

/// Within single quotes fish takes a backslash for an escape only before a backslash or a quote, so
/// no other character needs one.
std::string fish_quoted(const std::string& text) {
  std::string doubled;
  for (const char c : text) {
    if (c == '\\') doubled += '\\';
    doubled += c;
  }
  return shell_quoted(doubled, quote);
}

/// The part of a line that says what completes a value: the choices and nothing else, or names of
/// files.
std::string source_of(const OptionValue& value) {
  if (!value.choices.empty()) {
    std::string words;
    for (const std::string& choice : value.choices) words += (words.empty() ? "" : " ") + choice;
    return " -x -a '" + words + "'";
  }
  switch (value.completion) {
    case Completion::nothing:
      return " -x";
    case Completion::file:
      return " -r -F";
    case Completion::folder:
      return " -x -a '(__fish_complete_directories)'";
  }
  throw std::logic_error("not a completion");
}

std::string option_line(const Option& option, const std::string& condition) {
  std::string text = line + condition + " -l " + option.name.substr(2);
  if (option.letter != '\0') text += std::string(" -s ") + option.letter;
  if (!option.is_flag()) text += source_of(option.value);
  return text + " -d " + fish_quoted(in_few_words(option)) + "\n";
}

/// The line for arguments that are files or choices. There is one line for all of them, as fish
/// does not tell their places apart.
std::string argument_line(const Option& option, const std::string& condition) {
  if (option.value.choices.empty()) return line + condition + " -F\n";
  return line + condition + source_of(option.value) + "\n";
}

std::string lines_of(const OptionList& options, const std::string& condition) {
  std::string text;
  bool has_argument = false;
  for (const Option& option : options.options()) {
    if (!option.is_argument()) text += option_line(option, condition);
    if (!option.is_argument() || has_argument) continue;
    text += argument_line(option, condition);
    has_argument = true;
  }
  return text;
}

}  // namespace

std::string fish_completion(const Catalogue& commands) {
  std::string text = "# Completion of thiessen's command lines in fish.\n" + std::string(line) +
                     " -f\n" + lines_of(commands.options(), " -n __fish_use_subcommand");
  for (const auto& command : commands.all()) {
    text += line + std::string(" -n __fish_use_subcommand -a ") + command->name() + " -d " +
            fish_quoted(command->description()) + "\n";
  }
  for (const auto& command : commands.all()) {
    text += lines_of(command->options(),
                     " -n '__fish_seen_subcommand_from " + std::string(command->name()) + "'");
  }
  return text;
}

}  // namespace thiessen::cli

#include "cli/help/help.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "base/error.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t column = 28;
constexpr std::size_t width = 80;

/// An entry in two columns: the term on the left, and beside it the text, broken between words.
std::string entry(const std::string& term, std::string_view text) {
  std::string all = "  " + term;
  const std::string next_line = "\n" + std::string(column, ' ');
  std::size_t at = all.size();
  const auto break_line = [&] {
    all += next_line;
    at = column;
  };
  if (at + 1 < column) {
    all.append(column - at, ' ');
    at = column;
  } else {
    break_line();
  }
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (at > column && at + 1 + word.size() > width) break_line();
    if (at > column) all += ' ';
    at += word.size() + (at > column ? 1 : 0);
    all += word;
  }
  return all + "\n";
}

std::string entry(const Option& option) {
  std::string term = (option.letter == '\0' ? "" : option.short_name() + ", ") + option.name;
  if (!option.value.kind.empty()) term += " " + option.value.kind;
  return entry(term, option.help);
}

std::string sections(const OptionList& options) {
  std::string text;
  for (const std::string& group : options.groups()) {
    text += group + ":\n";
    for (const Option& option : options.options()) {
      if (option.group == group) text += entry(option);
    }
    text += "\n";
  }
  return text;
}

std::string heading(std::string description, const std::string& usage) {
  if (description[0] >= 'a' && description[0] <= 'z')
    description[0] = static_cast<char>(description[0] - 'a' + 'A');
  return description + "\n\nUsage: thiessen " + usage + "\n\n";
}

std::string example_of(const Command& command, const std::string& program) {
  return "Example, in the folder of the clone:\n  " + printable(program) + " " + command.name() +
         " " + command.example() + "\n";
}

}  // namespace

std::string usage_of(const Command& command) {
  std::string text = command.name();
  for (const Option& option : command.options().options()) {
    const bool is_required = option.need == Need::required;
    if (!is_required && !option.is_argument()) continue;
    std::string word = option.short_name();
    if (!option.is_argument()) word += " " + option.value.kind;
    text += is_required ? " " + word : " [" + word + "]";
  }
  return text + " [options]";
}

std::string help_on(const Catalogue& commands) {
  std::string text = heading("Areal rainfall from rain gauges by exact Thiessen polygons.",
                             "COMMAND FILES [options]") +
                     sections(commands.options()) + "Commands:\n";
  for (const auto& command : commands.all()) text += entry(command->name(), command->description());
  return text + "\n" + example_of(*commands.all().front(), commands.program());
}

std::string help_on(const Catalogue& commands, const Command& command) {
  const std::string notes = command.notes();
  return heading(command.description(), usage_of(command)) + sections(command.options()) + notes +
         (notes.empty() ? "" : "\n") + example_of(command, commands.program());
}

}  // namespace thiessen::cli

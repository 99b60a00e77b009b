#include "cli/options/help.h"

#include <algorithm>
#include <string_view>

namespace thiessen::cli {
namespace {

constexpr std::size_t column = 28;
constexpr std::size_t width = 80;

/// The term in the left column, and beside it the text, broken between words.
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

bool is_shown(const CLI::Option& option) {
  return option.get_required() || option.get_positional();
}

}  // namespace

std::string short_name(const CLI::Option& option) {
  return option.get_snames().empty() ? option.get_name() : "-" + option.get_snames().front();
}

std::string value_of(const CLI::Option& option) {
  std::string text = option.get_type_name();
  const std::size_t last = text.rfind('|');
  if (last != std::string::npos) text.replace(last, 1, " or ");
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos;) {
    text.replace(at, 1, ", ");
  }
  return text;
}

HelpFormatter::HelpFormatter() {
  label("Positionals", "Files");
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  std::string text = app->get_description();
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  return text + "\n";
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  std::string text = "\nUsage: " + name;
  if (!app->get_subcommands({}).empty()) return text + " COMMAND FILES [options]\n\n";
  for (const CLI::Option* option : app->get_options()) {
    if (!is_shown(*option)) continue;
    std::string word = short_name(*option);
    if (!option->get_positional()) word += " " + option->get_type_name();
    text += option->get_required() ? " " + word : " [" + word + "]";
  }
  return text + " [options]\n\n";
}

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  std::string text = group + ":\n";
  for (const CLI::Option* option : options) text += make_option(option, is_positional);
  return is_positional ? text + "\n" : text;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  std::string term = is_positional ? option->get_name(true, false) : option->get_name(false, true);
  if (const std::size_t comma = term.find(','); comma != std::string::npos)
    term.insert(comma + 1, " ");
  const std::string value = option->get_type_name();
  if (!is_positional && !value.empty()) term += " " + value;
  return entry(term, option->get_description());
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

}  // namespace thiessen::cli

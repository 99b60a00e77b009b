#include "cli/options/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <set>

namespace thiessen::cli {
namespace {

constexpr const char* end_of_options = "--";

void declare(CLI::App& app, const Option& option) {
  const std::string names = (option.letter == '\0' ? "" : option.short_name() + ",") + option.name;
  CLI::Option* declared = option.is_flag() ? app.add_flag(names) : app.add_option(names);
  declared->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->allow_extra_args(false);
}

void declare_all(CLI::App& app, const std::vector<const OptionList*>& lists) {
  for (const OptionList* list : lists) {
    for (const Option& option : list->options()) {
      if (option.is_argument() || app.get_option_no_throw(option.name) != nullptr) continue;
      declare(app, option);
    }
  }
}

/// Gives each option whose value is left out the text that stands for it.
void fill_in_values(std::vector<std::string>& arguments,
                    const std::vector<const OptionList*>& lists) {
  const auto may_lack_value = [&](const std::string& name) {
    for (const OptionList* list : lists) {
      const Option* const option = name.starts_with("--") ? list->find(name) : nullptr;
      if (option != nullptr) return option->value.when_left_out;
    }
    return std::string();
  };
  for (std::size_t i = 0; i < arguments.size() && arguments[i] != end_of_options; ++i) {
    const bool has_value =
        i + 1 < arguments.size() && (arguments[i + 1] == "-" || !arguments[i + 1].starts_with('-'));
    const std::string otherwise = may_lack_value(arguments[i]);
    if (!has_value && !otherwise.empty()) arguments[i] += "=" + otherwise;
  }
}

/// The spelling of an option in messages: as it is written on the command line.
std::string spelling_of(const CLI::Option& option, const std::vector<std::string>& arguments) {
  const std::string name = option.get_name();
  const bool is_written_out =
      std::any_of(arguments.begin(), arguments.end(), [&](const std::string& argument) {
        return argument == name || argument.starts_with(name + "=");
      });
  return is_written_out || option.get_snames().empty() ? name : "-" + option.get_snames().front();
}

std::vector<Arguments::Given> given_options(const CLI::App& app,
                                            const std::vector<std::string>& arguments) {
  std::vector<Arguments::Given> given;
  std::set<const CLI::Option*> seen;
  for (const CLI::Option* option : app.parse_order()) {
    if (!seen.insert(option).second) continue;
    given.push_back({option->get_name(), spelling_of(*option, arguments), option->results()});
  }
  return given;
}

/// Sorts the arguments that the parser does not know. They come in their order, and so does the
/// sign that ends the options.
void sort_remaining(const std::vector<std::string>& remaining, Arguments& sorted) {
  bool only_words = false;
  for (const std::string& argument : remaining) {
    const bool is_option = argument.size() > 1 && argument[0] == '-';
    if (!only_words && argument == end_of_options) {
      only_words = true;
    } else if (!only_words && is_option) {
      sorted.unknown.push_back(argument.substr(0, argument.find('=')));
    } else {
      sorted.words.push_back(argument);
    }
  }
}

}  // namespace

Arguments parse_arguments(std::vector<std::string> arguments,
                          const std::vector<const OptionList*>& lists) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  declare_all(app, lists);
  fill_in_values(arguments, lists);
  Arguments sorted;
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ArgumentMismatch& mismatch) {  // what() begins with the option's name
    const std::string sentence = mismatch.what();
    sorted.incomplete = sentence.substr(0, sentence.find(':'));
  }
  sorted.options = given_options(app, arguments);
  sort_remaining(app.remaining(), sorted);
  return sorted;
}

}  // namespace thiessen::cli

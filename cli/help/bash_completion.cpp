#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "cli/help/completion.h"

namespace thiessen::cli {
namespace {

constexpr const char* beginning = R"(# Completion of thiessen's command lines in bash.
_thiessen() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
  local command='' place=0 awaits_value='' options='' words='' files='' i only_arguments=''
  COMPREPLY=()
  # Bash parts --name=value at the sign.
  if [ "$word" = = ]; then
    word=''
  elif [ "$before" = = ]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  # ... and EPSG:4326 at the colon: what follows one is not a word of its own.
  if [ "$word" = : ] || [ "$before" = : ]; then return; fi
  for ((i = 1; i < COMP_CWORD; i++)); do
    if [ "${COMP_WORDS[i]}" = : ]; then
      i=$((i + 1))
      continue
    fi
    if [ -n "$awaits_value" ]; then
      [ "${COMP_WORDS[i]}" = = ] || awaits_value=''
      continue
    fi
    case ${COMP_WORDS[i]} in
      --) only_arguments=yes ;;
)";

constexpr const char* after_options = R"() awaits_value=yes ;;
      -?*) ;;
      *)
        if [ -z "$command" ]; then
          command=${COMP_WORDS[i]}
        else
          place=$((place + 1))
        fi
        ;;
    esac
  done
  case $command in
)";

constexpr const char* ending = R"(  esac
  if [ -z "$awaits_value$only_arguments" ] && [[ $word == -* ]]; then
    words=$options files=''
  fi
  if [ -n "$words" ]; then
    mapfile -t COMPREPLY < <(compgen -W "$words" -- "$word")
  elif [ -n "$files" ]; then
    compopt -o filenames 2> /dev/null
    mapfile -t COMPREPLY < <(compgen "$files" -- "$word")
  fi
}
complete -F _thiessen thiessen
)";

std::string joined(const std::vector<std::string>& words, const std::string& between) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

std::vector<std::string> spellings(const Option& option) {
  if (option.letter == '\0') return {option.name};
  return {option.name, option.short_name()};
}

/// The pattern of all options that a value follows: `--crs | -o | --output`.
std::string options_with_values(const Catalogue& commands) {
  std::vector<std::string> names;
  for (const auto& command : commands.all()) {
    for (const Option& option : command->options().options()) {
      if (option.is_argument() || option.is_flag()) continue;
      for (const std::string& name : spellings(option)) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
      }
    }
  }
  return joined(names, " | ");
}

/// What may stand for a value, as settings of the script's variables; empty where nothing can be
/// offered.
std::string setting(const OptionValue& value) {
  if (!value.choices.empty()) return "words='" + joined(value.choices, " ") + "'";
  switch (value.completion) {
    case Completion::nothing:
      return "";
    case Completion::file:
      return "files=-f";
    case Completion::folder:
      return "files=-d";
  }
  throw std::logic_error("not a completion");
}

std::string names_of(const OptionList& options) {
  std::vector<std::string> names;
  for (const Option& option : options.options()) {
    if (option.is_argument()) continue;
    for (const std::string& name : spellings(option)) names.push_back(name);
  }
  return joined(names, " ");
}

/// The branches of a `case` that complete the values of options.
std::string branches_of_values(const OptionList& options) {
  std::string text;
  for (const Option& option : options.options()) {
    if (option.is_argument() || setting(option.value).empty()) continue;
    text +=
        "          " + joined(spellings(option), " | ") + ") " + setting(option.value) + " ;;\n";
  }
  return text;
}

/// The branches of a `case` that complete the arguments by their place.
std::string branches_of_arguments(const OptionList& options) {
  std::string text;
  const std::vector<const Option*> arguments = options.arguments();
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string set = setting(arguments[i]->value);
    if (!set.empty()) text += "          " + std::to_string(i) + ") " + set + " ;;\n";
  }
  return text;
}

std::string branch_of(const Command& command) {
  const OptionList& options = command.options();
  return "    " + std::string(command.name()) + ")\n      options='" + names_of(options) +
         "'\n      if [ -n \"$awaits_value\" ]; then\n        case $before in\n" +
         branches_of_values(options) + "        esac\n      else\n        case $place in\n" +
         branches_of_arguments(options) + "        esac\n      fi\n      ;;\n";
}

}  // namespace

std::string bash_completion(const Catalogue& commands) {
  std::string text = beginning + ("      " + options_with_values(commands)) + after_options;
  text += "    '')\n      options='" + names_of(commands.options()) +
          "'\n      [ -n \"$awaits_value\" ] || words='" + joined(commands.names(), " ") +
          "'\n      ;;\n";
  for (const auto& command : commands.all()) text += branch_of(*command);
  return text + ending;
}

}  // namespace thiessen::cli

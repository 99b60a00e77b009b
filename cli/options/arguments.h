#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/option_list.h"

namespace thiessen::cli {

/// What stands on a command line, sorted into options and words.
struct Arguments {
  struct Given {
    std::string name;                ///< `--output`
    std::string spelling;            ///< `-o` where it is never written out
    std::vector<std::string> texts;  ///< its values, or `true` where a flag has none
  };
  /// Options that one of the lists has, in the order in which each first stands.
  std::vector<Given> options;
  /// Options that none of the lists has, as they are written, without the value after a `=`.
  std::vector<std::string> unknown;
  /// What is neither an option nor the value of one, and all that follows a `--`.
  std::vector<std::string> words;
  /// The last option, where the value that it needs is missing.
  std::optional<std::string> incomplete;
};

/// Options may stand anywhere, `--name=value` and `-ovalue` are read, and letters may stand
/// together; whether an option needs a value, the lists tell. Requires that an option of several
/// lists is a flag in all of them or in none. This is the one place that knows CLI11.
Arguments parse_arguments(std::vector<std::string> arguments,
                          const std::vector<const OptionList*>& lists);

}  // namespace thiessen::cli

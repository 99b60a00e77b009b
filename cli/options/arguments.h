#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/option_list.h"

namespace thiessen::cli {

/// A command line sorted into options and words.
struct Arguments {
  struct Given {
    std::string name;                ///< `--output`
    std::string spelling;            ///< spelling in messages: `-o` where it is never written out
    std::vector<std::string> texts;  ///< its values, or `true` for a flag, which has none
  };
  /// The options that one of the lists has, in the order in which each is given first.
  std::vector<Given> options;
  /// The options that none of the lists has, as they are written, without the value after a `=`.
  std::vector<std::string> unknown;
  /// All that is neither an option nor the value of one, and all that follows a `--`.
  std::vector<std::string> words;
  /// The last option, where it needs a value and none follows.
  std::optional<std::string> incomplete;
};

/// Sorts a command line by the options that the lists declare. Options may stand anywhere,
/// `--name=value` and `-ovalue` are read, and letters may stand together; the lists say whether an
/// option needs a value. Requires that an option of several lists is a flag in all of them or in
/// none. This is the one place that knows CLI11.
Arguments parse_arguments(std::vector<std::string> arguments,
                          const std::vector<const OptionList*>& lists);

}  // namespace thiessen::cli

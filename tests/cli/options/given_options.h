#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cli/options/reading.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

/// A block of options, and a command line that gives them.
template <typename Block>
struct Given {
  /// Reads the words that follow the command's name. Returns what is said of them; nothing where
  /// they are taken.
  std::string refusal(std::vector<std::string> words) {
    words.insert(words.begin(), "command");
    const Arguments said = parse_arguments(words, {&options});
    const std::string unknown = unknown_option(options, said);
    if (!unknown.empty()) return "unknown option '" + unknown + "'";
    try {
      Warnings warnings;
      read_options(options, said, warnings);
    } catch (const UsageError& error) {
      return error.text;
    }
    return {};
  }
  void read(std::vector<std::string> words) { EXPECT_EQ(refusal(std::move(words)), ""); }
  /// What the block says of options that contradict each other; nothing where none do.
  template <typename... More>
  std::string contradiction(More... more) const {
    try {
      block.check(more...);
    } catch (const UsageError& error) {
      return error.text;
    }
    return {};
  }

  OptionList options;
  Block block;
};

}  // namespace thiessen::cli

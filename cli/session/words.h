#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace thiessen::cli {

/// Splits a command into its words, which blanks part. A word in single or double quotes may hold
/// blanks; text from a # at the beginning of a word on is a comment. Throws Error for a quote that
/// is never closed.
std::vector<std::string> words_of(std::string_view line);

}  // namespace thiessen::cli

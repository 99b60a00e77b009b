#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace thiessen::cli {

/// The words of a command, parted by blanks. A word in single or double quotes may hold blanks;
/// what follows a # at the beginning of a word is a comment. Throws Error for a quote that is never
/// closed.
std::vector<std::string> words_of(std::string_view line);

}  // namespace thiessen::cli

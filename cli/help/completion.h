#pragma once

#include <string>

#include "cli/catalogue/catalogue.h"

namespace thiessen::cli {

/// \file
/// Scripts that teach a shell to complete the program's command lines: commands, the options of the
/// command in the line, the values of a choice, and names of files where a file belongs. Every
/// build of a version gives the same bytes.

/// The script for bash 4 or later, to be sourced, or put as `thiessen` where bash-completion looks.
std::string bash_completion(const Catalogue& commands);
/// The script for zsh, to be put as `_thiessen` into a folder of its fpath.
std::string zsh_completion(const Catalogue& commands);
/// The script for fish, to be put as `thiessen.fish` where fish looks.
std::string fish_completion(const Catalogue& commands);

/// Puts the text in single quotes for a shell. `quote` is written in place of a single quote
/// within: `'\''` in bash and zsh, `\'` in fish.
std::string shell_quoted(const std::string& text, const std::string& quote);
/// The purpose of an option in few words: its help up to the first semicolon.
std::string in_few_words(const Option& option);

}  // namespace thiessen::cli

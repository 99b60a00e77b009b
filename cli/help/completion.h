#pragma once

#include <string>

#include "cli/commands/commands.h"

namespace thiessen::cli {

/// Scripts that teach a shell to complete the program's command lines: commands, the options of the
/// command that stands there, values out of a list, and names of files where a file belongs. The
/// same bytes from every build of a version.

/// To be sourced by bash 4 or later, or put where bash-completion looks, as `thiessen`.
std::string bash_completion(const Commands& commands);
/// To be put into a folder of zsh's fpath, as `_thiessen`.
std::string zsh_completion(const Commands& commands);
/// To be put where fish looks, as `thiessen.fish`.
std::string fish_completion(const Commands& commands);

/// The text in single quotes as a shell reads them; `quote` is what stands for a quote within:
/// `'\''` in bash and zsh, `\'` in fish.
std::string shell_quoted(const std::string& text, const std::string& quote);
/// What an option is for, in few words: its help up to the first semicolon.
std::string in_few_words(const Option& option);

}  // namespace thiessen::cli

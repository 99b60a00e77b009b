#pragma once

#include <string>

#include "cli/commands/commands.h"

namespace thiessen::cli {

/// How the help looks: the arguments and the options that must be there in the usage line, options
/// in groups, no line longer than a terminal's 80 columns where a word allows it.

/// The help on the program as a whole.
std::string help_on(const Commands& commands);
/// The help on one of them.
std::string help_on(const Commands& commands, const Command& command);

/// The command's name and what follows it: `rain STATIONS BASINS RAINFALL [options]`.
std::string usage_of(const Command& command);

}  // namespace thiessen::cli

#pragma once

#include <string>

#include "cli/commands/commands.h"

namespace thiessen::cli {

/// How the help looks: the arguments and the options that must be there in the usage line, options
/// in groups, no line longer than a terminal's 80 columns where a word allows it. `program` is the
/// name by which it was called, for examples that run.

/// The help on the program as a whole.
std::string help_on(const Commands& commands, const std::string& program);
/// The help on a command.
std::string help_on(const Command& command, const std::string& program);

/// The command's name and what follows it: `rain STATIONS BASINS RAINFALL [options]`.
std::string usage_of(const Command& command);

}  // namespace thiessen::cli

#pragma once

#include <string>

#include "cli/commands/commands.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

/// What is said of a command line that names what does not exist, with the nearest names.

/// `command` is null where none is chosen: then the options of all are looked at.
UsageError unknown_option(const Commands& commands, const Command* command,
                          const std::string& option);
UsageError unknown_command(const Commands& commands, const std::string& name);
UsageError no_command(const Commands& commands);

/// The hint of all other faults in the use of a command.
std::string where_help_is(const Command& command);

}  // namespace thiessen::cli

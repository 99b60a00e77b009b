#pragma once

#include <string>

#include "cli/catalogue/catalogue.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

/// \file
/// The errors of a command line that names what does not exist, with the nearest names as a hint.

/// The error for an option that does not exist. `command` is null where no command is chosen: then
/// the options of all commands are compared.
UsageError unknown_option(const Catalogue& commands, const Command* command,
                          const std::string& option);
UsageError unknown_command(const Catalogue& commands, const std::string& name);
UsageError no_command(const Catalogue& commands);

/// The hint for any other fault in the use of a command: where to find its help.
std::string where_help_is(const Command& command);

}  // namespace thiessen::cli

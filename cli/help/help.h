#pragma once

#include <string>

#include "cli/catalogue/catalogue.h"

namespace thiessen::cli {

/// \file
/// The help: the usage line has the arguments and the options that are required, options stand in
/// groups, and no line is longer than a terminal's 80 columns where a word allows it.

/// The help on the program as a whole.
std::string help_on(const Catalogue& commands);
/// The help on one command.
std::string help_on(const Catalogue& commands, const Command& command);

/// The usage line of a command: its name and what follows it, as in `rain STATIONS BASINS RAINFALL
/// [options]`.
std::string usage_of(const Command& command);

}  // namespace thiessen::cli

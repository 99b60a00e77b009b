#pragma once

#include <memory>
#include <vector>

#include "cli/commands/command.h"

namespace thiessen::cli {

std::unique_ptr<Command> make_run_command();
std::unique_ptr<Command> make_cells_command();
std::unique_ptr<Command> make_weights_command();
std::unique_ptr<Command> make_rain_command();
std::unique_ptr<Command> make_map_command();
std::unique_ptr<Command> make_check_command();
std::unique_ptr<Command> make_tessel_command();

/// All of them, in the order of the help.
std::vector<std::unique_ptr<Command>> make_commands();

}  // namespace thiessen::cli

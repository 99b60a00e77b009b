#include "cli/commands/commands.h"

namespace thiessen::cli {

std::vector<std::unique_ptr<Command>> make_commands() {
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(make_run_command());
  commands.push_back(make_cells_command());
  commands.push_back(make_weights_command());
  commands.push_back(make_rain_command());
  commands.push_back(make_map_command());
  commands.push_back(make_check_command());
  commands.push_back(make_tessel_command());
  return commands;
}

}  // namespace thiessen::cli

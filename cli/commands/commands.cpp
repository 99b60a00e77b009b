#include "cli/commands/commands.h"

#include <utility>

namespace thiessen::cli {

Commands::Commands(std::string program) : Catalogue(std::move(program)) {
  add(make_run_command());
  add(make_cells_command());
  add(make_weights_command());
  add(make_rain_command());
  add(make_map_command());
  add(make_isohyets_command());
  add(make_check_command());
  add(make_tessel_command());
  add(make_help_command(*this));
}

}  // namespace thiessen::cli

#pragma once

#include <memory>
#include <string>

#include "cli/catalogue/catalogue.h"

namespace thiessen::cli {

std::unique_ptr<Command> make_run_command();
std::unique_ptr<Command> make_cells_command();
std::unique_ptr<Command> make_weights_command();
std::unique_ptr<Command> make_rain_command();
std::unique_ptr<Command> make_map_command();
std::unique_ptr<Command> make_isohyets_command();
std::unique_ptr<Command> make_check_command();
std::unique_ptr<Command> make_tessel_command();
/// Makes the command `help`, which explains the commands that the catalogue holds by now, and
/// itself. The catalogue must outlive it.
std::unique_ptr<Command> make_help_command(const Catalogue& catalogue);

/// The program's commands, in the order of the help.
class Commands : public Catalogue {
 public:
  /// `program` is the name by which the program was called.
  explicit Commands(std::string program);
};

}  // namespace thiessen::cli

#pragma once

#include <string>

#include "cli/commands/commands.h"

namespace thiessen::cli {

/// The manual page thiessen.1 in the language of man(7): every command, every argument and option
/// under its heading with the commands that have it, what the commands' notes say, and their
/// examples. The same bytes from every build of a version.
std::string manual(const Commands& commands);

}  // namespace thiessen::cli

#pragma once

#include <string>

#include "cli/catalogue/catalogue.h"

namespace thiessen::cli {

/// The manual page thiessen.1 in the language of man(7): every command, every argument and option
/// under its heading with the commands that have it, the notes of the commands, and their examples.
/// Every build of a version gives the same bytes.
std::string manual(const Catalogue& commands);

}  // namespace thiessen::cli

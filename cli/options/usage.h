#pragma once

#include <CLI/CLI.hpp>

#include "cli/commands/command.h"

namespace thiessen::cli {

/// What is wrong with a command line that `app` could not parse, in one line, and where the help
/// is.
UsageError usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace thiessen::cli

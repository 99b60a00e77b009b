#pragma once

namespace thiessen::cli {

/// The whole program: parses the command line, runs the command, and turns what it throws into
/// sentences on the standard error and an exit status.
int run_program(int argc, char** argv);

}  // namespace thiessen::cli

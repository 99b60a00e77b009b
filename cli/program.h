#pragma once

namespace thiessen::cli {

/// Has a lack of memory that nothing catches be told as such, instead of aborting the program. What
/// else nothing catches aborts it as before, in the C++ library's words.
void watch_for_uncaught() noexcept;

/// The whole program: parses the command line, runs the command, and turns what it throws into
/// sentences on the standard error and an exit status.
int run_program(int argc, char** argv);

}  // namespace thiessen::cli

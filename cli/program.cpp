#include "cli/program.h"

#include <exception>
#include <new>
#include <string>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "cli/command_line.h"
#include "cli/lacking_memory.h"
#include "cli/terminal/messages.h"
#include "gdal/drivers.h"

namespace thiessen::cli {
namespace {

enum Status { done = 0, failed = 1, wrong_usage = 2 };

constexpr const char* before_error = "thiessen: error: ";

int run_command(Command& command, Warnings& warnings) {
  const auto report = [&] {
    if (!command.quiet()) print(warnings);
  };
  try {
    start_gdal();
    command.run(warnings);
  } catch (const ReaderGone&) {
    throw;
  } catch (...) {
    report();
    throw;
  }
  try {
    report();
  } catch (const std::bad_alloc&) {  // the outputs are there, and whole
    print_lack_of_memory("for the warnings");
  }
  return done;
}

/// Prints an error, and where memory is short that it may be the cause: libraries tell a lack of it
/// as something else.
void print_error(const Error& error) {
  const bool is_short = memory_is_short();
  print(before_error, error);
  const bool is_told = shown(error.messages().front().placed()).find("memory") != std::string::npos;
  if (is_short && !is_told) print_hint("memory ran out, which may be the cause");
}

int run_and_report(int argc, char** argv) {
  const char* when_interrupted = "interrupted";
  try {
    hold_standard_streams();
    watch_for_interrupts();
    CommandLine command_line(argc > 0 ? argv[0] : "thiessen");
    Warnings warnings;
    Command* command = command_line.parse({argv + 1, argv + argc}, warnings);
    if (command == nullptr) return done;
    when_interrupted = command->when_interrupted();
    return run_command(*command, warnings);
  } catch (const UsageError& error) {
    print(before_error, error.text, printable(error.hint));
    return wrong_usage;
  } catch (const ReaderGone&) {
    return failed;
  } catch (const Error& error) {
    print_error(error);
    return failed;
  } catch (const Interrupted& interrupted) {
    print(before_error, when_interrupted, "");
    return interrupted.exit_status();
  } catch (const std::bad_alloc&) {
    print_lack_of_memory();
    return failed;
  } catch (const std::exception& error) {
    print(before_error, std::string("a fault of the program itself: ") + error.what(),
          "please report it with the input");
    return failed;
  }
}

}  // namespace

int run_program(int argc, char** argv) {
  watch_for_lack_of_memory();
  try {
    return run_and_report(argc, argv);
  } catch (const std::bad_alloc&) {  // there was no memory for the message of what went wrong
    print_lack_of_memory();
    return failed;
  }
}

}  // namespace thiessen::cli

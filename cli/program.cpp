#include "cli/program.h"

#include <unistd.h>
#ifdef __GLIBC__
#include <execinfo.h>
#endif

#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "cli/command_line.h"
#include "cli/terminal/messages.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "map/opencv/fonts.h"

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

/// Where nothing else is left to do: what has no name vanishes with the process, and what lies
/// under a hidden one is removed by the next run that writes there.
[[noreturn]] void end_without_memory() noexcept {
  print_lack_of_memory();
  ::_exit(failed);
}

/// What the C++ library does about an exception that nothing caught: it says which, and aborts.
std::terminate_handler end_of_library = nullptr;

/// A library that throws for want of memory where nothing may be thrown calls this.
[[noreturn]] void end_after_uncaught() noexcept {
  try {
    if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    end_without_memory();
  } catch (...) {  // the library's own end, below, tells of it
  }
  if (end_of_library != nullptr) end_of_library();
  std::abort();
}

/// The C library loads what it needs to end a thread when it is first needed, and gives up where
/// there is no memory for it then.
void load_unwinder() noexcept {
#ifdef __GLIBC__
  void* frame = nullptr;
  ::backtrace(&frame, 1);
#endif
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
    print(before_error, error);
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

void watch_for_uncaught() noexcept {
  const std::terminate_handler before = std::set_terminate(end_after_uncaught);
  if (before != end_after_uncaught) end_of_library = before;
}

int run_program(int argc, char** argv) {
  watch_for_uncaught();
  load_unwinder();
  when_gdal_lacks_memory(end_without_memory);
  when_fonts_break_off(end_without_memory);
  try {
    return run_and_report(argc, argv);
  } catch (const std::bad_alloc&) {  // there was no memory for the message of what went wrong
    print_lack_of_memory();
    return failed;
  }
}

}  // namespace thiessen::cli

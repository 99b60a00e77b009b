#include "cli/program.h"

#include <iostream>
#include <new>
#include <string>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/interrupt.h"
#include "cli/command_line.h"
#include "gdal/drivers.h"

namespace thiessen::cli {
namespace {

enum Status { done = 0, failed = 1, wrong_usage = 2 };

void print(const char* kind, const std::string& text, const std::string& hint) {
  std::cerr << "thiessen: " << kind << ": " << text << '\n';
  if (!hint.empty()) std::cerr << "hint: " << printable(hint) << '\n';
}

void print(const Error& error) {
  for (const Message& message : error.messages()) print("error", message.sentence(), message.hint);
  if (error.unlisted() > 0) print("error", "and " + std::to_string(error.unlisted()) + " more", "");
}

void print(const Warnings& warnings) {
  for (const Message& message : warnings.messages())
    print("warning", message.sentence(), message.hint);
}

int run_command(Command& command) {
  Warnings warnings;
  const auto report = [&] {
    if (!command.quiet()) print(warnings);
  };
  try {
    start_gdal();
    command.run(warnings);
  } catch (...) {
    report();
    throw;
  }
  report();
  return done;
}

}  // namespace

int run_program(int argc, char** argv) {
  const char* when_interrupted = "interrupted";
  try {
    hold_standard_streams();
    watch_for_interrupts();
    CommandLine command_line(argc > 0 ? argv[0] : "thiessen");
    Command* command = command_line.parse({argv + 1, argv + argc});
    if (command == nullptr) return done;
    when_interrupted = command->when_interrupted();
    return run_command(*command);
  } catch (const UsageError& error) {
    print("error", error.text, error.hint);
    return wrong_usage;
  } catch (const Error& error) {
    print(error);
    return failed;
  } catch (const Interrupted& interrupted) {
    print("error", when_interrupted, "");
    return interrupted.exit_status();
  } catch (const std::bad_alloc&) {
    print("error", "not enough memory", "");
    return failed;
  } catch (const std::exception& error) {
    print("error", std::string("a fault of the program itself: ") + error.what(),
          "please report it with the input");
    return failed;
  }
}

}  // namespace thiessen::cli

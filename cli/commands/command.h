#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "base/error.h"

namespace thiessen::cli {

/// A wrong command line: exit status 2.
struct UsageError {
  std::string text;
  std::string hint;
};

/// A verb of the command line.
class Command {
 public:
  virtual ~Command() = default;
  virtual const char* name() const = 0;
  virtual const char* description() const = 0;
  /// What follows the command's name in a line that runs in the project's folder, for the help.
  virtual const char* example() const = 0;
  /// What the help says between the options and the example; may be empty.
  virtual std::string notes() const { return {}; }
  /// What is said where a signal ends the command; a literal.
  virtual const char* when_interrupted() const { return "interrupted; nothing was written"; }
  /// Declares files and options. Opens nothing.
  virtual void set_up(CLI::App& app) = 0;
  /// Does the work. Throws UsageError, Error and Interrupted.
  virtual void run(Warnings& warnings) = 0;
  /// Whether warnings are not to be shown.
  virtual bool quiet() const = 0;
};

}  // namespace thiessen::cli

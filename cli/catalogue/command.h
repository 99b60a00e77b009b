#pragma once

#include <string>

#include "base/error.h"
#include "cli/options/option_list.h"
#include "cli/options/usage_error.h"

namespace thiessen::cli {

/// A command of the program. Its constructor declares its files and options, and opens nothing.
class Command {
 public:
  Command() = default;
  virtual ~Command() = default;
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  virtual const char* name() const = 0;
  virtual const char* description() const = 0;
  /// The words that follow the command's name in an example of the help, which runs in the
  /// project's folder.
  virtual const char* example() const = 0;
  /// Text of the help between the options and the example; may be empty.
  virtual std::string notes() const { return {}; }
  /// The sentence that is printed where a signal ends the command. It has to be a literal, as the
  /// command is gone by then.
  virtual const char* when_interrupted() const { return "interrupted; nothing was written"; }
  /// Throws UsageError for options that contradict each other. Opens nothing.
  virtual void check() const {}
  /// Does the work, after the options are read and checked. Throws UsageError, Error and
  /// Interrupted.
  virtual void run(Warnings& warnings) = 0;
  /// Whether warnings are to be kept back.
  virtual bool quiet() const = 0;

  OptionList& options() { return options_; }
  const OptionList& options() const { return options_; }

 private:
  OptionList options_;
};

}  // namespace thiessen::cli

#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/file.h"

namespace thiessen::cli {

/// Where the commands of a session come from, and where what they say goes.
struct Surroundings {
  OutputFile& output;
  Warnings& warnings;
  bool is_terminal;                 ///< a person reads the output: every command says what it did
  bool is_standard_input;           ///< the commands come from it
  std::vector<std::string> inputs;  ///< files that may not be written
};

/// Carries out the commands of a session.
class Interpreter {
 public:
  virtual ~Interpreter() = default;
  /// Carries out what stands on a line; false where it ends the session. Throws Error, without a
  /// place in the script, where that cannot be done: then nothing is changed.
  virtual bool perform(std::string_view line) = 0;
  /// How many faults `check` has found.
  virtual std::size_t faults() const = 0;
};

/// Dimension 2 or 3.
std::unique_ptr<Interpreter> make_interpreter(std::size_t dimension, Surroundings surroundings);

/// The commands' names, in the order of the help.
std::vector<std::string> session_commands();
/// What they do, and the form of what they print.
std::string session_help();

}  // namespace thiessen::cli

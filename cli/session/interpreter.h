#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/file.h"
#include "map/plot/tessellation_picture.h"

namespace thiessen::cli {

/// What draws a session's pictures, in the plane and in space. A session that shows none needs
/// neither.
struct SessionPictures {
  std::vector<unsigned char> (*of_plane)(const Tessellation<2>& tessellation,
                                         const NumberOf& number_of,
                                         const std::optional<PlaneWindow>& window,
                                         const PlotSize& size) = nullptr;
  std::vector<unsigned char> (*of_space)(const Tessellation<3>& tessellation,
                                         const NumberOf& number_of, const std::optional<View>& view,
                                         const PlotSize& size) = nullptr;
};

/// The surroundings of a session: where its commands come from, where its answers go, and
/// what draws.
struct Surroundings {
  OutputFile& output;
  Warnings& warnings;
  bool is_terminal;                 ///< a person reads the output: every command says what it did
  bool is_standard_input;           ///< the commands come from the standard input
  std::vector<std::string> inputs;  ///< files that may not be overwritten
  SessionPictures pictures{};
};

/// Carries out the commands of a session.
class Interpreter {
 public:
  virtual ~Interpreter() = default;
  /// Carries out the command on a line, and returns false where it ends the session. Throws Error,
  /// without a place in the script, where the command cannot be carried out, and Interrupted after
  /// Ctrl-C: then nothing is changed.
  virtual bool perform(std::string_view line) = 0;
  /// The number of faults that `check` has found so far.
  virtual std::size_t faults() const = 0;
};

/// Makes the interpreter of a session in 2 or 3 dimensions.
std::unique_ptr<Interpreter> make_interpreter(std::size_t dimension, Surroundings surroundings);

/// The names of the commands, in the order of the help.
std::vector<std::string> session_commands();
/// Explains the commands, and the form of what they print.
std::string session_help();

}  // namespace thiessen::cli

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "cli/session/command_arguments.h"
#include "cli/session/interpreter.h"
#include "cli/session/script_lines.h"
#include "cli/session/words.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "fuzzers/message_laws.h"

namespace thiessen::fuzzers {
namespace {

constexpr std::size_t longest_script = 60;
constexpr char text_separator = '\x1e';  // between a script and the CSV that it loads

/// A session with a script's lines. What cannot be done changes nothing, and what is there is
/// sound.
class Script {
 public:
  Script(std::size_t dimension, std::string_view text, std::string_view csv)
      : dimension_(static_cast<int>(dimension)),
        script_(text),
        csv_(csv),
        output_(printed_.output()),
        interpreter_(cli::make_interpreter(dimension, {output_, warnings_, false, false, {}})) {}

  void run() {
    cli::ScriptLines lines(script_.name());
    std::size_t line = 0;
    while (line++ < longest_script) {
      const auto text = lines.next([] {});
      if (!text || !perform(*text)) break;
    }
    while (does("redo")) continue;
    const std::string last = print();
    while (does("undo")) continue;
    require(print().empty(), "something is left before the first step");
    while (does("redo")) continue;
    require(print() == last, "another table once all is undone and redone");
    require_sound();
  }

 private:
  /// False where the line ends the session.
  bool perform(std::string_view text) {
    const std::string before = print();
    try {
      const auto line = harmless(text);
      if (!line) return true;
      if (!interpreter_->perform(*line)) return false;
    } catch (const Error& error) {
      require_sentences(error);
      require(print() == before, "a bad command changed something");
    }
    require_sound();
    return true;
  }
  void require_sound() {
    interpreter_->perform("check");
    require(interpreter_->faults() == 0, "not sound");
    take();
  }
  /// Files are neither written nor read, but `load` reads the CSV, which may be a saved session; of
  /// `show` and `watch` the words are read.
  std::optional<std::string> harmless(std::string_view text) const {
    const std::vector<std::string> words = cli::words_of(text);
    if (words.empty()) return std::nullopt;
    if (words.front() == "load") return "load " + csv_.name();
    if (words.front() == "print") return "print";
    if (words.front() == "save" || words.front() == "cells" || words.front() == "export")
      return std::nullopt;
    if (words.front() != "show" && words.front() != "watch") return std::string(text);
    cli::read_show_arguments(words.front(), dimension_, {words.begin() + 1, words.end()});
    return std::nullopt;
  }

  bool does(const char* command) {
    try {
      return interpreter_->perform(command);
    } catch (const Error&) {
      return false;
    }
  }
  std::string print() {
    take();
    interpreter_->perform("print");
    return take();
  }
  std::string take() {
    output_.flush();
    return printed_.take();
  }

  int dimension_;
  MemoryFile script_;
  MemoryFile csv_;
  MemoryFile printed_;
  OutputFile output_;
  Warnings warnings_;
  std::unique_ptr<cli::Interpreter> interpreter_;
};

}  // namespace

void fuzz_script(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const std::size_t dimension = 2 + bytes.below(2);
  const std::string_view text = bytes.until(text_separator);
  try {
    Script(dimension, text, bytes.until(text_separator)).run();
  } catch (const Error& error) {
    require_sentences(error);
  }
}

}  // namespace thiessen::fuzzers

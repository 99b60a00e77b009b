#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "base/utf8.h"
#include "cli/session/interpreter.h"
#include "cli/session/script_lines.h"
#include "cli/session/words.h"
#include "fuzzers/bytes.h"
#include "fuzzers/fuzzers.h"
#include "fuzzers/memory_file.h"
#include "geometry/predicates.h"
#include "geometry/space_predicates.h"
#include "text/geojson_audit.h"
#include "text/points_file.h"
#include "text/text_bytes.h"

namespace thiessen::fuzzers {
namespace {

constexpr std::size_t longest_script = 60;
constexpr char text_separator = '\x1e';  // between a script and the CSV that it loads

/// That every message is a sentence: one line of text, and nothing a terminal would obey.
void require_sentences(const Error& error) {
  require(!error.messages().empty(), "an error without a message");
  for (const Message& message : error.messages()) {
    const std::string sentence = message.sentence();
    require(!message.text.empty() && !find_invalid_utf8(sentence), "a message that is no text");
    for (const char c : sentence)
      require(static_cast<unsigned char>(c) >= 0x20, "a message with a control character");
  }
}

/// A session with a script's lines. What cannot be done changes nothing, and what is there is
/// sound.
class Script {
 public:
  Script(std::size_t dimension, std::string_view text, std::string_view csv)
      : script_(text),
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
  /// Files are neither written nor read, but `load` reads the CSV.
  std::optional<std::string> harmless(std::string_view text) const {
    const std::vector<std::string> words = cli::words_of(text);
    if (words.empty() || words.front() == "show") return std::nullopt;
    if (words.front() == "load") return "load " + csv_.name();
    if (words.front() == "print") return "print";
    return std::string(text);
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

  MemoryFile script_;
  MemoryFile csv_;
  MemoryFile printed_;
  OutputFile output_;
  Warnings warnings_;
  std::unique_ptr<cli::Interpreter> interpreter_;
};

template <int Dimension>
void read_as_points(std::string_view text) {
  const MemoryFile file(text);
  Warnings warnings;
  const auto points = read_points<Dimension>(file.name(), warnings);
  require(!points.empty(), "no points, and no error");
  for (const auto& p : points) require(in_exact_range(p), "a point outside the range");
}

void read_as_numbers(std::string_view text) {
  for (const DecimalMark mark : {DecimalMark::point, DecimalMark::comma}) {
    std::size_t from = 0;
    while (from <= text.size()) {
      const std::size_t end = std::min(text.find_first_of(" \n", from), text.size());
      if (const auto number = parse_number(text.substr(from, end - from), mark)) {
        require(std::isfinite(number.value), "a number that is not finite");
        const auto again = parse_number(shortest_text(number.value));
        require(again && again.value == number.value, "a number that does not read back");
      }
      from = end + 1;
    }
  }
}

}  // namespace

void fuzz_script(std::span<const std::uint8_t> input) {
  Bytes bytes(input);
  const std::size_t kind = bytes.below(8);
  try {
    if (kind < 4) {
      const std::string_view text = bytes.until(text_separator);
      Script(2 + kind % 2, text, bytes.until(text_separator)).run();
    } else if (kind == 4) {
      read_as_points<2>(bytes.rest());
    } else if (kind == 5) {
      read_as_points<3>(bytes.rest());
    } else if (kind == 6) {
      TextBytes text{std::string(bytes.rest())};
      audit_geojson("fuzzed.geojson", text);
    } else {
      read_as_numbers(bytes.rest());
    }
  } catch (const Error& error) {
    require_sentences(error);
  }
}

}  // namespace thiessen::fuzzers

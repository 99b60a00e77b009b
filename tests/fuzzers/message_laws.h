#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"
#include "fuzzers/bytes.h"

namespace thiessen::fuzzers {

/// Requires that every message is a sentence: one line of text, and nothing a terminal would obey.
inline void require_sentences(const Error& error) {
  require(!error.messages().empty(), "an error without a message");
  for (const Message& message : error.messages()) {
    const std::string sentence = message.sentence();
    require(!message.text.empty() && !find_invalid_utf8(sentence), "a message that is no text");
    for (const char c : sentence)
      require(static_cast<unsigned char>(c) >= 0x20, "a message with a control character");
  }
}

/// Requires that every message is a sentence and names the file, and a line of it where it names
/// one. `lines` is the number of the file's lines.
inline void require_placed(const Error& error, const std::string& file, std::size_t lines) {
  require_sentences(error);
  for (const Message& message : error.messages()) {
    const bool in_text =
        message.file.empty() && message.text.plain().find(file) != std::string::npos;
    require(message.file == file || in_text, "a message without its file: " + message.sentence());
    require(message.line <= lines, "a line beyond the end: " + message.sentence());
  }
}

/// The lines of a text, however they end, and one more for what follows the last end.
inline std::size_t lines_of(std::string_view text) {
  std::size_t count = 1;
  for (const char c : text) count += c == '\n' || c == '\r' ? 1u : 0u;
  return count;
}

}  // namespace thiessen::fuzzers

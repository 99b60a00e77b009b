#include "cli/help/roff.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "text/text_lines.h"

namespace thiessen::cli {
namespace {

constexpr std::size_t width = 80;

/// Guards a line that begins with a dot or a quote, as the formatter would take it for a command.
std::string guarded(const std::string& line) {
  const bool is_command = !line.empty() && (line[0] == '.' || line[0] == '\'');
  return is_command ? "\\&" + line : line;
}

/// A letter beyond ASCII by its number, so that every formatter knows it: \[u7DEF].
std::string roff_character(std::string_view letter) {
  const auto first = static_cast<unsigned char>(letter[0]);
  std::uint32_t number = first & (0x7FU >> letter.size());
  for (const char c : letter.substr(1))
    number = number << 6U | (static_cast<unsigned char>(c) & 0x3FU);
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "\\[u%04X]", number);
  return text.data();
}

}  // namespace

std::string as_sentence(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (!text.ends_with('.')) text += '.';
  return text;
}

std::string roff_phrase(std::string_view text) {
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0xC0) {
      const std::size_t length = byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : 2;
      escaped += roff_character(text.substr(i, length));
      i += length - 1;
    } else if (c == '\\') {
      escaped += "\\e";
    } else if (c == '-') {
      escaped += "\\-";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string roff_bold(std::string_view text) {
  return "\\fB" + roff_phrase(text) + "\\fR";
}

std::string roff_italic(std::string_view text) {
  return "\\fI" + roff_phrase(text) + "\\fR";
}

std::string roff_paragraph(std::string_view text) {
  std::string all;
  std::string line;
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    const std::string escaped = roff_phrase(word);
    if (!line.empty() && line.size() + 1 + escaped.size() > width - 2) {
      all += guarded(line) + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + escaped;
  }
  return line.empty() ? all : all + guarded(line) + "\n";
}

std::string roff_verbatim(std::string_view lines) {
  std::string text = ".EX\n";
  while (!lines.empty()) text += guarded(roff_phrase(take_line(lines))) + "\n";
  return text + ".EE\n";
}

}  // namespace thiessen::cli

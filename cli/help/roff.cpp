#include "cli/help/roff.h"

#include <algorithm>
#include <cstddef>

namespace thiessen::cli {
namespace {

constexpr std::size_t width = 80;

/// Guards a line that begins with a dot or a quote, as the formatter would take it for a command.
std::string guarded(const std::string& line) {
  const bool is_command = !line.empty() && (line[0] == '.' || line[0] == '\'');
  return is_command ? "\\&" + line : line;
}

}  // namespace

std::string roff_phrase(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '\\') {
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
  while (!lines.empty()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    text += guarded(roff_phrase(line)) + "\n";
  }
  return text + ".EE\n";
}

}  // namespace thiessen::cli

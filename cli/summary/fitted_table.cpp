#include "cli/summary/fitted_table.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace thiessen::cli {
namespace {

constexpr std::size_t shortest_name = 8;
constexpr std::string_view ellipsis = "\xE2\x80\xA6";

struct Range {
  std::uint32_t first;
  std::uint32_t last;
};

/// Where Unicode's wide characters are (UAX 11), in whole blocks.
constexpr std::array wide_blocks{
    Range{0x1100, 0x115F}, Range{0x2E80, 0xA4CF}, Range{0xAC00, 0xD7A3},  Range{0xF900, 0xFAFF},
    Range{0xFE30, 0xFE6F}, Range{0xFF00, 0xFF60}, Range{0x20000, 0x3FFFD}};

bool begins_character(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
}

/// A character of a text in UTF-8: how many bytes it has, and how many columns it takes.
struct Character {
  std::size_t bytes;
  std::size_t columns;
};

Character first_character(std::string_view text) {
  std::size_t bytes = 1;
  while (bytes < text.size() && !begins_character(text[bytes])) ++bytes;
  constexpr std::array<unsigned, 5> kept{0x7F, 0x7F, 0x1F, 0x0F, 0x07};
  std::uint32_t code =
      static_cast<unsigned char>(text.front()) & kept.at(std::min<std::size_t>(bytes, 4));
  for (std::size_t i = 1; i < bytes; ++i)
    code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  const auto holds = [&](const Range& range) { return range.first <= code && code <= range.last; };
  const bool is_wide = std::any_of(wide_blocks.begin(), wide_blocks.end(), holds);
  return {bytes, is_wide ? std::size_t{2} : std::size_t{1}};
}

std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const Character character = first_character(text);
    width += character.columns;
    text.remove_prefix(character.bytes);
  }
  return width;
}

/// The text, or as much of its beginning as leaves room for an ellipsis.
std::string cut_to(std::string_view text, std::size_t width) {
  if (width_of(text) <= width) return std::string(text);
  std::string kept;
  for (std::size_t used = 1; !text.empty();) {
    const Character character = first_character(text);
    used += character.columns;
    if (used > width) break;
    kept += text.substr(0, character.bytes);
    text.remove_prefix(character.bytes);
  }
  return kept + std::string(ellipsis);
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    if (c == ' ')
      words.emplace_back();
    else
      words.back() += c;
  }
  return words;
}

/// The words in lines of at most `width`, as few as hold them in their order. A longer word has a
/// line to itself.
std::vector<std::string> lines_of(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  for (const std::string& word : words_of(text)) {
    if (!lines.empty() && width_of(lines.back()) + 1 + width_of(word) <= width) {
      lines.back() += ' ' + word;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

std::size_t natural_width(const TableColumn& column) {
  std::size_t width = 0;
  for (const std::string& word : words_of(column.heading)) width = std::max(width, width_of(word));
  for (const std::string& value : column.values) width = std::max(width, width_of(value));
  return width;
}

/// The columns' widths and the blanks between them, as they fit into the lines.
class Widths {
 public:
  Widths(const std::vector<TableColumn>& columns, std::size_t width) {
    for (const TableColumn& column : columns) widths_.push_back(natural_width(column));
    if (total() > width) gap_ = 1;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!columns[i].is_name || total() <= width) continue;
      const std::size_t over = total() - width;
      const std::size_t least = std::min(widths_[i], shortest_name);
      widths_[i] = std::max(least, widths_[i] - std::min(over, widths_[i]));
    }
  }

  std::size_t operator[](std::size_t column) const { return widths_[column]; }
  std::size_t gap() const { return gap_; }

 private:
  std::size_t total() const {
    std::size_t sum = gap_ * (widths_.size() - 1);
    for (const std::size_t width : widths_) sum += width;
    return sum;
  }

  std::vector<std::size_t> widths_;
  std::size_t gap_ = 2;
};

void append_row(std::string& text, const std::vector<TableColumn>& columns, const Widths& widths,
                const std::vector<std::string>& row) {
  const std::size_t begin = text.size();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string shown = cut_to(row[i], widths[i]);
    const std::string blanks(widths[i] - width_of(shown), ' ');
    if (i > 0) text.append(widths.gap(), ' ');
    text += columns[i].is_name ? shown + blanks : blanks + shown;
  }
  text.erase(std::max(begin, text.find_last_not_of(' ') + 1));
  text += '\n';
}

}  // namespace

std::string fitted(std::vector<TableColumn> columns, std::size_t width) {
  const Widths widths(columns, width);
  std::vector<std::vector<std::string>> headings;
  std::size_t lines = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    headings.push_back(lines_of(columns[i].heading, widths[i]));
    lines = std::max(lines, headings.back().size());
  }
  std::string text;
  std::vector<std::string> row(columns.size());
  for (std::size_t line = 0; line < lines; ++line) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const std::size_t above = lines - headings[i].size();
      row[i] = line < above ? "" : headings[i][line - above];
    }
    append_row(text, columns, widths, row);
  }
  for (std::size_t r = 0; r < columns.front().values.size(); ++r) {
    for (std::size_t i = 0; i < columns.size(); ++i) row[i] = columns[i].values[r];
    append_row(text, columns, widths, row);
  }
  return text;
}

std::string wrapped(const std::string& lines, std::size_t width) {
  std::string text;
  for (std::size_t begin = 0; begin < lines.size();) {
    const std::size_t end = std::min(lines.find('\n', begin), lines.size());
    for (const std::string& line : lines_of(lines.substr(begin, end - begin), width))
      text += line + '\n';
    begin = end + 1;
  }
  return text;
}

}  // namespace thiessen::cli

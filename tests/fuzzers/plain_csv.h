#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/utf8.h"

namespace thiessen::fuzzers {

/// A row of a CSV, and the line on which it begins.
struct PlainRow {
  std::size_t line = 0;
  std::vector<std::string> fields;
  friend bool operator==(const PlainRow& a, const PlainRow& b) = default;
};

/// The rules of CsvReader (csv_reader.h) told once more, a character at a time, as its judge.
class PlainCsv {
 public:
  PlainCsv(std::string_view text, char separator) : rest_(text), separator_(separator) {}

  /// The rows, the header first; nothing where the text breaks a rule.
  std::optional<std::vector<PlainRow>> read() {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    if (find_invalid_utf8(rest_) || rest_.find('\0') != std::string_view::npos) return std::nullopt;
    if (rest_.starts_with(mark)) rest_.remove_prefix(mark.size());
    if (rest_.starts_with(mark)) return std::nullopt;
    while (!rest_.empty()) {
      if (pass_blank_line()) continue;
      rows_.push_back({line_, {}});
      if (!read_row()) return std::nullopt;
      if (rows_.back().fields.size() != rows_.front().fields.size()) return std::nullopt;
    }
    if (rows_.empty()) return std::nullopt;
    return std::move(rows_);
  }

  /// Whether the header's names may stand: none twice, and no sign of another separator.
  static bool is_header(const std::vector<std::string>& names, char separator) {
    if (names.size() == 1) {
      for (const char other : {';', '\t', '|', ','})
        if (other != separator && names[0].find(other) != std::string::npos) return false;
    }
    std::vector<std::string> sorted = names;
    std::erase(sorted, "");
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
  }

 private:
  static bool ends_line(char c) { return c == '\n' || c == '\r'; }

  bool pass_blank_line() {
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    const std::string_view line = rest_.substr(0, end);
    const bool parts = !blank_separates() && line.find(separator_) != std::string_view::npos;
    if (parts || !trimmed(line).empty()) return false;
    rest_.remove_prefix(end);
    pass_line_end();
    return true;
  }
  void pass_line_end() {
    if (rest_.empty()) return;
    const bool two = rest_.starts_with("\r\n");
    rest_.remove_prefix(two ? 2 : 1);
    ++line_;
  }

  /// Of blanks that separate, several are as one, and those at a row's ends are none.
  bool blank_separates() const { return separator_ == ' '; }

  bool read_row() {
    for (;;) {
      while (blank_separates() && rest_.starts_with(' ')) rest_.remove_prefix(1);
      if (blank_separates() && !rows_.back().fields.empty() &&
          (rest_.empty() || ends_line(rest_[0])))
        break;
      if (!(rest_.starts_with('"') ? read_quoted() : read_bare())) return false;
      if (rest_.empty() || ends_line(rest_[0])) break;
      if (rest_[0] != separator_) return false;
      rest_.remove_prefix(1);
    }
    pass_line_end();
    return true;
  }
  bool read_quoted() {
    std::string field;
    for (rest_.remove_prefix(1);; rest_.remove_prefix(1)) {
      if (rest_.empty()) return false;
      if (rest_[0] == '"') {
        rest_.remove_prefix(1);
        if (!rest_.starts_with('"')) break;
      } else if (rest_[0] == '\n' || (rest_[0] == '\r' && !rest_.starts_with("\r\n"))) {
        ++line_;
      }
      field += rest_[0];
    }
    rows_.back().fields.push_back(field);
    return true;
  }
  bool read_bare() {
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != separator_ && !ends_line(rest_[end])) ++end;
    const std::string_view field = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (field.find('"') != std::string_view::npos) return false;
    rows_.back().fields.emplace_back(rows_.size() == 1 ? trimmed(field) : field);
    return true;
  }

  std::string_view rest_;
  char separator_;
  std::size_t line_ = 1;
  std::vector<PlainRow> rows_;
};

}  // namespace thiessen::fuzzers

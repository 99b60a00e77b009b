#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/file.h"

namespace thiessen::cli {

/// Reads the lines of a script: UTF-8, ended by LF, CRLF or CR, though the last line need not be
/// ended; a byte order mark at the beginning is skipped. Throws Error, with file and line, for a
/// NUL byte, bytes that are not UTF-8, and a line beyond the limit.
class ScriptLines {
 public:
  static constexpr std::size_t longest_line = std::size_t{64} << 10;

  /// Opens the script; `-` is the standard input. Throws Error as InputFile does.
  explicit ScriptLines(const std::string& file) : input_(file) {}
  /// The lines of a file that is open.
  explicit ScriptLines(InputFile file) : input_(std::move(file)) {}

  /// The name of the script as the user gave it.
  const std::string& file() const { return input_.name(); }
  /// The number of the line last read, from 1.
  std::size_t line() const { return line_; }
  /// Reads the next line, valid until the one after it; none at the end. Calls `before_waiting`
  /// whenever all that has arrived is read, so that answers can be shown before the wait.
  std::optional<std::string_view> next(const std::function<void()>& before_waiting);

 private:
  bool read_more();
  std::string_view take(std::size_t end, std::size_t next);
  void check(std::string_view text) const;

  InputFile input_;
  std::string buffer_;
  std::size_t at_ = 0;      // position in the buffer
  std::size_t origin_ = 0;  // position of the buffer in the file
  std::size_t line_ = 0;
  // A line feed that comes next belongs to the line before, as its CR was read already.
  bool after_return_ = false;
};

}  // namespace thiessen::cli

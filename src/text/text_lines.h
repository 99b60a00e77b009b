#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "base/file.h"

namespace thiessen {

/// Reads the lines of a text, wherever its bytes come from. Lines end in LF or CRLF; a byte order
/// mark of UTF-8 is skipped.
class TextLines {
 public:
  static constexpr std::size_t longest_line = std::size_t{1} << 20;

  explicit TextLines(InputFile input) : input_(std::move(input)) {}

  const std::string& file() const { return input_.name(); }
  /// Reads the next line, which is valid until the one after it; none at the end. Throws Error
  /// where the line is longer than the limit or cannot be read, and Interrupted.
  std::optional<std::string_view> next();
  /// The number of the line that was read last, from 1.
  std::size_t line() const { return line_; }
  /// The share of the text that is read, from 0 to 1; NaN where its length is not known.
  double share_read() const;

 private:
  bool read_more();

  InputFile input_;
  std::string buffer_;
  std::size_t at_ = 0;
  std::size_t line_ = 0;
  std::size_t read_ = 0;
};

/// Takes the next line off the front of a text, and returns it without its end, LF or CRLF. The
/// last line needs none. Of an empty text the line is empty.
std::string_view take_line(std::string_view& text);

}  // namespace thiessen

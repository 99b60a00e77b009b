#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/descriptor.h"

namespace thiessen {

/// A place in a file of lines.
struct LinePlace {
  std::uint64_t offset = 0;  ///< in bytes
  std::size_t line = 1;
};

/// Reads the lines of plain files from any line on; one file is open at a time. Lines end in LF or
/// CRLF.
class SeekableLines {
 public:
  static constexpr std::size_t longest_line = std::size_t{4} << 10;

  /// Goes to the line that begins at a place. Throws Error if the file cannot be opened, or cannot
  /// be read twice.
  void go(const std::string& file, LinePlace place);
  /// Reads the next line, which is valid until the one after it; none at the end. Throws Error if
  /// the line is longer than the limit or cannot be read, and Interrupted if a signal came.
  std::optional<std::string_view> next();
  /// The place of the line that was read last.
  LinePlace place() const { return place_; }
  /// Whether the line that was read last has a line end.
  bool ends() const { return ends_; }

 private:
  void open(const std::string& file);
  bool read_more();

  std::string name_;
  Descriptor file_;
  std::string buffer_;
  std::size_t at_ = 0;
  std::uint64_t origin_ = 0;  ///< of the buffer in the file
  LinePlace place_;
  std::size_t next_line_ = 1;
  bool ends_ = false;
};

}  // namespace thiessen

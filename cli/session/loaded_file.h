#pragma once

#include <string>

#include "base/file.h"

namespace thiessen::cli {

/// A file that a session loads, known by its beginning: the points of a CSV, or the table that a
/// session has printed.
class LoadedFile {
 public:
  /// Opens the file, `-` for the standard input, and reads its first line with anything in it.
  /// Throws Error as InputFile does.
  explicit LoadedFile(const std::string& name);

  bool is_table() const { return is_table_; }
  /// The file from its beginning on. It can be had once.
  InputFile input() &&;

 private:
  InputFile file_;
  std::string beginning_;
  bool is_table_ = false;
};

}  // namespace thiessen::cli

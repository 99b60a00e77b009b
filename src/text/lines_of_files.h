#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "text/table.h"

namespace thiessen {

/// Numbers the lines of several files that are read one after the other as one table, so that no
/// two have the same number. Of a single file the number is the line.
class LinesOfFiles {
 public:
  /// Says that the lines that follow are of this file.
  void begin(std::string file);
  /// The number of a line, from 1, of the file that is read.
  std::size_t number(std::size_t line) { return last_ = files_.back().before + line; }
  /// Requires a number that has been given.
  RowPlace place(std::size_t number) const;

 private:
  struct File {
    std::string name;
    std::size_t before;  ///< the last number of the files before
  };

  std::vector<File> files_;
  std::size_t last_ = 0;
};

}  // namespace thiessen

#pragma once

#include <string>
#include <vector>

#include "cli/options/option_list.h"
#include "text/csv_dialect.h"

namespace thiessen::cli {

/// The names of columns, where all that are given are numbers: the file may have no header. Else
/// none.
std::vector<std::string> numbers_in(const std::vector<std::string>& columns);

/// The options that say how CSV files are written: all of them, or one alone.
class CsvOptionsOf {
 public:
  /// Declares `--separator` and its like for all files.
  void declare(OptionGroup& group);
  /// Declares `--stations-separator` and its like, for the file `which` alone. Returns them.
  std::vector<const Option*> declare_for(OptionGroup& group, const std::string& which);
  const CsvDialect& said() const { return said_; }
  /// What is said of this file, and of all files where nothing is.
  CsvDialect or_else(const CsvDialect& all) const;

 private:
  CsvDialect said_;
};

}  // namespace thiessen::cli

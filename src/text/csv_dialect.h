#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/wording.h"

namespace thiessen {

/// What the user says of how a CSV file is written. What is not said is found out.
struct CsvDialect {
  char separator = '\0';                 ///< '\0': not said
  bool decimal_comma = false;            ///< false: not said
  std::string encoding = {};             ///< empty: not said
  std::optional<std::size_t> skip = {};  ///< lines before the header
  bool skip_is_of_all = false;           ///< they are said of all CSV files, not of this one
  /// Numbers by which columns are called. Where the first row has no such name, the file has no
  /// header, and its columns are called 1, 2, 3...
  std::vector<std::string> numbers = {};
  std::vector<std::string> names = {};     ///< of the columns of a file that has no header
  std::vector<std::string> repeated = {};  ///< names that the header may have more than once
  std::string input = {};                  ///< what the user calls the file; see setting_for
};

/// What to do where lines that were to be skipped in one file were skipped in all.
inline Wording hint_of_skip() {
  return setting("skip") + " is of all CSV files, and " + setting("rainfall_skip") + ", " +
         setting("stations_skip") + " and " + setting("basins_skip") + " are of one each";
}

}  // namespace thiessen

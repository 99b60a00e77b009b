#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace thiessen {

/// What the user says of how a CSV file is written. What is not said is found out.
struct CsvDialect {
  char separator = '\0';                 ///< '\0': not said
  bool decimal_comma = false;            ///< false: not said
  std::string encoding = {};             ///< empty: not said
  std::optional<std::size_t> skip = {};  ///< lines before the header
  /// Numbers by which columns are called. Where the first row has no such name, the file has no
  /// header, and its columns are called 1, 2, 3...
  std::vector<std::string> numbers = {};
  std::vector<std::string> names = {};     ///< of the columns of a file that has no header
  std::vector<std::string> repeated = {};  ///< names that the header may have more than once
  std::string input = {};                  ///< what the user calls the file; see setting_for
};

}  // namespace thiessen

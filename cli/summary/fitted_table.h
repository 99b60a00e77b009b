#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace thiessen::cli {

/// A column of a table: its words stand over it, below each other where they are wider than its
/// values.
struct TableColumn {
  std::string heading;
  std::vector<std::string> values;
  bool is_name = false;  ///< flush left, and cut short where the table is too wide
};

/// Sets columns of equal length side by side in lines of at most `width` characters. Where that is
/// too narrow, names are cut, and end in an ellipsis, but to no fewer than eight characters; beyond
/// that lines are longer, for numbers are never cut. Characters that are as wide as two, as those
/// of Chinese, count as two.
std::string fitted(std::vector<TableColumn> columns, std::size_t width);

/// Breaks lines between words, so that each has at most `width` columns, as fitted() counts them; a
/// longer word has a line to itself. The last line ends in a line break, given or not.
std::string wrapped(const std::string& lines, std::size_t width);

}  // namespace thiessen::cli

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace thiessen::cli {

/// One key of a TOML file, and its values as a command line would have them.
struct TomlSetting {
  std::string key;
  std::size_t line;
  /// Texts as they are; numbers, dates and times in the form that is shortest; `true` or
  /// `false`. An array has its values in their order.
  std::vector<std::string> texts;
  bool is_truth = false;  ///< true or false, without quotes
  bool is_text = true;    ///< texts alone, in quotes
};

/// Reads the keys of a TOML file (version 1.0), in the order of their lines. The file is `-` for
/// the standard input. Throws Error where it cannot be read, is not TOML, or has a table, a NUL or
/// an array of arrays or of truths in it. This is the one place that knows toml++.
std::vector<TomlSetting> read_toml(const std::string& path);

/// The text as TOML writes it, in double quotes. Requires UTF-8.
std::string toml_text(std::string_view text);

}  // namespace thiessen::cli

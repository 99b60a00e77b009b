#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace thiessen {

/// A format that is read, by the extension of its files.
struct InputFormat {
  std::string_view extension;        ///< with its dot, in lower case
  std::vector<const char*> drivers;  ///< those of GDAL's that may open it; none: a CSV
};

/// The format that a file's name tells by its longest known extension; null where none is known.
const InputFormat* format_by_extension(const std::string& file);

/// Whether a format is one of spreadsheets.
bool is_spreadsheet(const InputFormat& format);

}  // namespace thiessen

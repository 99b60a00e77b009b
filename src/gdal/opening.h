#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Which of GDAL's drivers may read a file, and under which name GDAL must be given it.
struct Opening {
  std::vector<const char*> drivers;  ///< none: a CSV, for all that is known
  std::string name;                  ///< that GDAL cannot take for a connection
};

/// By the extension, or by the first bytes where that says nothing. Throws Error as read_by_gdal.
Opening find_opening(const std::string& file);

/// Whether `file` is for GDAL and not a CSV: by its extension, `PG:`, an archive's path, or what
/// its first bytes say. Throws Error for what no command reads: a folder, a missing file, a URL, a
/// connection other than PG:, a virtual file other than of a local archive, JSON as an argument.
bool read_by_gdal(const std::string& file);

}  // namespace thiessen

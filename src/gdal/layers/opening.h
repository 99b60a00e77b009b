#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// Which of GDAL's drivers may read a file, and the name under which GDAL must be given it.
struct Opening {
  /// How the bytes of a CSV are had.
  enum class Packing {
    none,     ///< as they stand in the file
    gzip,     ///< the file is their gzip
    archived  ///< by GDAL, under `name`: they stand in an archive
  };
  std::vector<const char*> drivers;  ///< empty where the file seems to be a CSV
  std::string name;                  ///< in a form that GDAL cannot take for a connection
  Packing packing = Packing::none;   ///< of a CSV
};

/// Finds out how a file is to be opened: by its extension, or by its first bytes where the
/// extension is not known. A .zip that holds one data set is that data set. Throws Error as
/// read_by_gdal does.
Opening find_opening(const std::string& file);

/// The files of a zip archive of data sets that may be one (see tables_in_archive); none where
/// `file` is no such archive, but a spreadsheet or the like. Throws Error where it is damaged.
std::vector<std::string> tables_in_zip(const std::string& file);

/// Whether `file` is read by GDAL rather than as a CSV: by its extension, `PG:`, an archive's path,
/// or its first bytes. Throws Error for files that no command reads: a folder, a missing file, a
/// URL, a connection other than PG:, a virtual file other than of a local archive, JSON as an
/// argument, an archive of several data sets; and for a picture, a document, a grid and the like,
/// which it names.
bool read_by_gdal(const std::string& file);

}  // namespace thiessen

#pragma once

#include <string>
#include <vector>

namespace thiessen {

/// The names of the files in a .zip, in its order. `name` is the archive as GDAL is given it,
/// `file` as messages name it. Throws Error where it is no whole archive.
std::vector<std::string> files_in_archive(const std::string& file, const std::string& name);

/// The one data set among the files of an archive: a file of a format that is read, where the files
/// beside a .shp and a text for the reader do not count. Throws Error where there is none, or
/// several, which it names.
std::string data_set_in_archive(const std::string& file, const std::vector<std::string>& names);

}  // namespace thiessen

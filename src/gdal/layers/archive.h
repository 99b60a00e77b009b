#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace thiessen {

/// The names of the files in a .zip, in its order. `name` is the archive as GDAL is given it,
/// `file` as messages name it. Throws Error where it is no whole archive.
std::vector<std::string> files_in_archive(const std::string& file, const std::string& name);

/// How many bytes all files of a .zip have together, as it states them, or the largest number where
/// they are more. Throws Error where it is no whole archive.
std::uint64_t unpacked_size(const std::string& file, const std::string& name);

/// The files of an archive that may be data sets: those of a format that is read, texts among them,
/// without the files beside a .shp and without what the archive's maker left in it.
std::vector<std::string> tables_in_archive(const std::vector<std::string>& names);

/// What a user calls a file in an archive: /vsizip/rain.zip/2020.csv. Braces hold the archive's
/// name where it does not end in .zip, for GDAL knows no other archives without them.
std::string path_in_archive(const std::string& file, const std::string& name);

/// The same in a hint, in quotes where a shell wants them.
std::string path_in_archive_quoted(const std::string& file, const std::string& name);

/// The names of files of an archive for a message: the first ten, and how many more there are.
std::string files_in_words(const std::vector<std::string>& names);

/// The one data set among the files of an archive: a file of a format that is read, where the files
/// beside a .shp and a text for the reader do not count. Throws Error where there is none, or
/// several, which it names.
std::string data_set_in_archive(const std::string& file, const std::vector<std::string>& names);

}  // namespace thiessen

#include "files/rainfall/archived_rainfall.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "files/rainfall/rainfall_content.h"
#include "gdal/layers/archive.h"
#include "gdal/layers/opening.h"

namespace thiessen {
namespace {

using FileNames = std::vector<std::string>;

/// The files of an archive that are no parts of a list of files, such as ArcSWAT's.
FileNames without_listed(const std::string& archive, FileNames names) {
  FileNames listed;
  for (const std::string& name : names) {
    for (std::string& file : files_listed_in(path_in_archive(archive, name)))
      listed.push_back(std::move(file));
  }
  std::erase_if(names, [&](const std::string& name) {
    return std::ranges::find(listed, path_in_archive(archive, name)) != listed.end();
  });
  return names;
}

[[noreturn]] void fail_of_several(const std::string& archive, const FileNames& names) {
  throw Error({archive, 0, "a zip archive of several files of readings: " + files_in_words(names),
               "name one as " + path_in_archive_quoted(archive, names.front()) + ", or several, " +
                   "each with " + setting("rainfall")});
}

/// Whether the archive's one data set is this file, whoever reads it.
bool is_data_set(const std::string& name, const std::string& archive, const FileNames& tables) {
  try {
    return data_set_in_archive(archive, tables) == name;
  } catch (const Error&) {
    return false;
  }
}

}  // namespace

std::string file_of_readings(const std::string& rainfall, Warnings& warnings) {
  const FileNames tables = tables_in_zip(rainfall);
  if (tables.size() < 2) return rainfall;
  FileNames known;
  FileNames unknown;
  for (const std::string& name : without_listed(rainfall, tables)) {
    const RainfallContent content = rainfall_content(path_in_archive(rainfall, name));
    if (content == RainfallContent::readings) known.push_back(name);
    if (content == RainfallContent::unknown) unknown.push_back(name);
  }
  if (known.size() > 1) fail_of_several(rainfall, known);
  const FileNames& found = known.empty() ? unknown : known;
  if (found.size() != 1 || is_data_set(found.front(), rainfall, tables)) return rainfall;
  std::string path = path_in_archive(rainfall, found.front());
  warnings.add_notice({path, 0, "is the file of readings in its archive, and alone is read", ""});
  return path;
}

}  // namespace thiessen

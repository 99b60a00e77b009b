#include "files/rainfall/rainfall_folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/utf8.h"
#include "gdal/layers/formats.h"

namespace thiessen {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& name) {
  std::error_code ignored;
  return name != "-" && fs::is_directory(name, ignored);
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code fault;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    if (!name.starts_with('.') && !entry->is_directory(ignored))
      names.push_back(entry->path().string());
  }
  if (fault) throw Error(Message{folder, 0, "cannot read: " + fault.message(), ""});
  std::sort(names.begin(), names.end());
  return names;
}

bool is_dly_file(const std::string& name) {
  return lower_case(name).ends_with(".dly");
}

/// Whether a file is of a format that is read, be it packed or not. The other files of a shapefile
/// beside its .shp do not count.
bool is_read(const std::string& name, const std::vector<std::string>& names) {
  const std::string lower = lower_case(name);
  if (lower.ends_with(".zip")) return true;
  const bool packed = lower.ends_with(".gz");
  if (format_by_extension(packed ? lower.substr(0, lower.size() - 3) : lower) == nullptr)
    return false;
  return !lower.ends_with(".dbf") ||
         std::none_of(names.begin(), names.end(), [&](const std::string& other) {
           return lower_case(other) == lower.substr(0, lower.size() - 4) + ".shp";
         });
}

std::vector<std::string> files_in(const std::string& folder, Warnings& warnings) {
  const std::vector<std::string> names = names_in(folder);
  if (std::any_of(names.begin(), names.end(), is_dly_file)) return {folder};
  std::vector<std::string> files;
  for (const std::string& name : names) {
    if (is_read(name, names)) files.push_back(name);
  }
  if (files.empty()) {
    throw Error(Message{folder, 0, "is a folder without a file of readings",
                        "readings are tables, or .dly files of GHCN-Daily"});
  }
  const std::size_t others = names.size() - files.size();
  if (others > 0) {
    warnings.add_notice({folder, 0,
                         others == 1
                             ? "a file of another kind is passed over"
                             : std::to_string(others) + " files of other kinds are passed over",
                         ""});
  }
  return files;
}

}  // namespace

std::vector<std::string> rainfall_files(const std::vector<std::string>& named, Warnings& warnings) {
  std::vector<std::string> files;
  for (const std::string& name : named) {
    if (!is_folder(name)) {
      files.push_back(name);
      continue;
    }
    for (std::string& file : files_in(name, warnings)) files.push_back(std::move(file));
  }
  return files;
}

}  // namespace thiessen

#include "gdal/layers/archive.h"

#include <cpl_string.h>
#include <cpl_vsi.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <limits>
#include <string_view>

#include "base/enumeration.h"
#include "base/error.h"
#include "base/utf8.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/formats.h"

namespace thiessen {
namespace {

/// What a program of the archive's maker left in it.
bool is_litter(const std::string& name) {
  const std::string last = name.substr(name.rfind('/') + 1);
  return name.starts_with("__MACOSX/") || last.starts_with(".");
}

std::string stem_of(const std::string& name) {
  return lower_case(name.substr(0, name.rfind('.')));
}

bool is_text(const std::string& name) {
  return format_by_extension(name)->extension == ".txt";
}

/// The data sets of an archive. Beside data a text tells about them; alone it is the data.
std::vector<std::string> data_sets(const std::vector<std::string>& names) {
  std::vector<std::string> texts = tables_in_archive(names);
  std::vector<std::string> found;
  std::copy_if(texts.begin(), texts.end(), std::back_inserter(found),
               [](const std::string& name) { return !is_text(name); });
  return found.empty() ? texts : found;
}

}  // namespace

std::vector<std::string> files_in_archive(const std::string& file, const std::string& name) {
  const GdalErrors errors;
  const CPLStringList entries(VSIReadDirRecursive(("/vsizip/{" + name + "}").c_str()));
  if (errors.failed() || entries.Count() == 0) {
    throw Error(Message{file,
                        0,
                        errors.failed() ? "no whole zip archive: " + errors.text()
                                        : "no whole zip archive, or an empty one",
                        {}});
  }
  std::vector<std::string> names;
  for (int i = 0; i < entries.Count(); ++i) {
    std::string entry = entries[i];
    if (!entry.ends_with('/')) names.push_back(std::move(entry));
  }
  return names;
}

std::uint64_t unpacked_size(const std::string& file, const std::string& name) {
  const GdalErrors errors;
  constexpr int all_folders = -1;
  VSIDIR* const folder = VSIOpenDir(("/vsizip/{" + name + "}").c_str(), all_folders, nullptr);
  std::uint64_t size = 0;
  if (folder != nullptr) {
    constexpr std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
    while (const VSIDIREntry* const entry = VSIGetNextDirEntry(folder))
      size += std::min<std::uint64_t>(entry->nSize, most - size);
    VSICloseDir(folder);
  }
  if (folder == nullptr || errors.failed())
    throw Error(Message{file, 0, "no whole zip archive, or an empty one", {}});
  return size;
}

std::vector<std::string> tables_in_archive(const std::vector<std::string>& names) {
  std::vector<std::string> found;
  std::copy_if(names.begin(), names.end(), std::back_inserter(found), [](const std::string& name) {
    return format_by_extension(name) != nullptr && !is_litter(name);
  });
  std::erase_if(found, [&](const std::string& name) {
    return lower_case(name).ends_with(".dbf") &&
           std::any_of(names.begin(), names.end(), [&](const std::string& other) {
             return lower_case(other).ends_with(".shp") && stem_of(other) == stem_of(name);
           });
  });
  return found;
}

std::string path_in_archive(const std::string& file, const std::string& name) {
  const bool is_plain = lower_case(file).ends_with(".zip");
  return "/vsizip/" + (is_plain ? file : "{" + file + "}") + "/" + name;
}

std::string path_in_archive_quoted(const std::string& file, const std::string& name) {
  std::string path = path_in_archive(file, name);
  const bool is_plain = std::all_of(path.begin(), path.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("/._-+:@%,").find(c) != std::string_view::npos;
  });
  return is_plain ? path : quoted(path, path.size());
}

std::string files_in_words(const std::vector<std::string>& names) {
  return names_up_to(10, names, 80);
}

std::string data_set_in_archive(const std::string& file, const std::vector<std::string>& names) {
  const std::vector<std::string> found = data_sets(names);
  if (found.empty()) {
    throw Error(Message{file, 0,
                        "a zip archive without a data set that is read: " + files_in_words(names),
                        "read are CSV, GeoJSON, GeoPackage, Shapefile, FlatGeobuf, KML and "
                        "spreadsheets"});
  }
  if (found.size() > 1) {
    throw Error(Message{file, 0, "a zip archive of several data sets: " + files_in_words(found),
                        "name one as " + path_in_archive_quoted(file, found.front())});
  }
  return found.front();
}

}  // namespace thiessen

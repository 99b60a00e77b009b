#include "gdal/layers/opening.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

struct Format {
  std::string_view extension;
  std::vector<const char*> drivers;
};

const std::vector<Format>& formats() {
  static const std::vector<Format> known = {{".geojson", {"GeoJSON"}},
                                            {".json", {"GeoJSON"}},
                                            {".gpkg", {"GPKG"}},
                                            {".shp", {"ESRI Shapefile"}},
                                            {".dbf", {"ESRI Shapefile"}},
                                            {".shz", {"ESRI Shapefile"}},
                                            {".shp.zip", {"ESRI Shapefile"}},
                                            {".fgb", {"FlatGeobuf"}},
                                            {".kml", {"LIBKML", "KML"}},
                                            {".kmz", {"LIBKML"}},
                                            {".xlsx", {"XLSX"}},
                                            {".xlsm", {"XLSX"}},
                                            {".ods", {"ODS"}},
                                            {".xls", {"XLS"}},
                                            {".csv", {}},
                                            {".tsv", {}},
                                            {".txt", {}}};
  return known;
}

[[noreturn]] void refuse(const std::string& file, std::string text, std::string hint = {}) {
  throw Error(Message{file, 0, std::move(text), std::move(hint)});
}

/// Whether a file's name looks like a connection: `WFS:`, `http:` and the like, but not the letter
/// of a drive.
bool looks_like_connection(std::string_view file) {
  const std::size_t colon = file.find(':');
  if (colon == std::string_view::npos || colon < 2) return false;
  return std::all_of(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '+' || c == '-';
  });
}

void require_readable(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) {
    const int reason = errno;
    if (looks_like_connection(file) || file.starts_with('{')) {
      refuse(file, std::string(std::strerror(reason)) +
                       "; only local files, archives of them and PG: connections are read");
    }
    if (file == "-") refuse(file, "standard input gives the readings, and no other file");
    refuse(file, file.empty() ? "the file's name is empty" : std::strerror(reason));
  }
  if (S_ISDIR(status.st_mode)) refuse(file, std::strerror(EISDIR));
  if (access(file.c_str(), R_OK) != 0) refuse(file, std::strerror(errno));
}

bool regular(const std::string& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

/// Requires a file in an archive of this machine. Archives may nest, but within them only local
/// files are read.
void require_local_archive(const std::string& file) {
  constexpr std::array<std::string_view, 3> archives = {"/vsizip/", "/vsigzip/", "/vsitar/"};
  std::string_view rest = file;
  for (bool stripped = true; stripped;) {
    stripped = false;
    for (const std::string_view archive : archives) {
      if (rest.starts_with(archive)) {
        rest.remove_prefix(archive.size() -
                           (rest.substr(archive.size()).starts_with("vsi") ? 1 : 0));
        stripped = true;
      }
    }
  }
  if (rest.find("/vsi") != std::string_view::npos || rest.starts_with("vsi") ||
      rest.find("://") != std::string_view::npos) {
    refuse(file,
           "not a file of this machine; of GDAL's virtual files only /vsizip/, /vsigzip/ and "
           "/vsitar/ of a local archive are read");
  }
  VSIStatBufL status;
  const GdalErrors errors;
  if (VSIStatExL(file.c_str(), &status, VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG) != 0) {
    refuse(file, "no such file in the archive, or no such archive");
  }
}

const Format* by_extension(const std::string& file) {
  const std::string name = lower_case(file);
  const Format* found = nullptr;
  for (const Format& format : formats()) {
    if (name.ends_with(format.extension) &&
        (found == nullptr || format.extension.size() > found->extension.size())) {
      found = &format;
    }
  }
  return found;
}

std::vector<const char*> by_first_bytes(const std::string& name) {
  static constexpr std::array<const char*, 9> drivers = {
      "GeoJSON", "GPKG", "ESRI Shapefile", "FlatGeobuf", "LIBKML", "XLSX", "ODS", "XLS", nullptr};
  const GdalErrors errors;
  GDALDriverH driver = GDALIdentifyDriverEx(name.c_str(), GDAL_OF_VECTOR, drivers.data(), nullptr);
  if (driver == nullptr) return {};
  return {GDALGetDriverShortName(driver)};
}

}  // namespace

Opening find_opening(const std::string& file) {
  start_gdal();
  if (file.starts_with("PG:")) return {{"PostgreSQL"}, file};
  const bool archive = file.starts_with("/vsi");
  if (archive) {
    require_local_archive(file);
  } else {
    require_readable(file);
    if (!regular(file)) return {{}, file};
  }
  const std::string name = file.starts_with('/') ? file : "./" + file;
  const Format* format = by_extension(file);
  Opening opening{format != nullptr ? format->drivers : by_first_bytes(name), name};
  if (archive && opening.drivers.empty()) {
    refuse(file, "a CSV file is not read from within an archive", "unpack it first");
  }
  return opening;
}

bool read_by_gdal(const std::string& file) {
  return !find_opening(file).drivers.empty();
}

}  // namespace thiessen

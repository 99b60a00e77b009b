#include "gdal/layers/opening.h"

#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/archive.h"
#include "gdal/layers/formats.h"
#include "gdal/layers/vsi_bytes.h"
#include "text/file_kind.h"

namespace thiessen {
namespace {

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

std::vector<const char*> by_first_bytes(const std::string& name) {
  static constexpr std::array<const char*, 9> drivers = {
      "GeoJSON", "GPKG", "ESRI Shapefile", "FlatGeobuf", "LIBKML", "XLSX", "ODS", "XLS", nullptr};
  const GdalErrors errors;
  GDALDriverH driver = GDALIdentifyDriverEx(name.c_str(), GDAL_OF_VECTOR, drivers.data(), nullptr);
  if (driver == nullptr) return {};
  return {GDALGetDriverShortName(driver)};
}

std::string first_bytes(const std::string& file, const std::string& name) {
  constexpr std::size_t enough = 4096;
  return VsiBytes(file, name).read_at(0, enough);
}

bool is_zip(std::string_view bytes) {
  return bytes.starts_with("PK\x03\x04") || bytes.starts_with("PK\x05\x06");
}

bool is_gzip(std::string_view bytes) {
  return bytes.starts_with("\x1f\x8b");
}

[[noreturn]] void refuse_kind(const std::string& file, const FileKind& kind) {
  refuse(file, "is " + std::string(kind.name) + ", which is not read", std::string(kind.hint));
}

bool has(const std::vector<std::string>& names, std::string_view wanted) {
  return std::find(names.begin(), names.end(), wanted) != names.end();
}

/// The driver of a spreadsheet that is a zip of these files; null where it is none.
const char* spreadsheet_of(const std::vector<std::string>& names) {
  if (has(names, "xl/workbook.xml")) return "XLSX";
  return has(names, "content.xml") && has(names, "mimetype") ? "ODS" : nullptr;
}

/// Refuses a spreadsheet that would unpack to far more than anybody writes. The sizes are those
/// that the archive states: GDAL unpacks no more of a file than that.
void require_no_bomb(const std::string& file, const std::string& name) {
  constexpr std::uint64_t megabyte = 1'000'000;
  constexpr std::uint64_t large = 256 * megabyte;
  constexpr std::uint64_t packed_at_most = 200;
  const std::uint64_t packed = VsiBytes(file, name).size();
  const std::uint64_t unpacked = unpacked_size(file, name);
  if (unpacked <= large || unpacked / packed_at_most <= packed) return;
  refuse(file,
         "is a spreadsheet of " + std::to_string(packed) + " bytes that unpacks to " +
             std::to_string(unpacked / megabyte) + " MB, which no table does",
         "save its table as CSV if it is sound");
}

Opening sheet_opening(const std::string& file, const std::string& name, const char* driver) {
  require_no_bomb(file, name);
  return {{driver}, name};
}

/// Opens a zip that no format's extension explains: a spreadsheet under another name, or an archive
/// of one data set.
Opening zip_opening(const std::string& file, const std::string& name) {
  const std::vector<std::string> names = files_in_archive(file, name);
  const auto has_file = [&](std::string_view wanted) { return has(names, wanted); };
  if (const auto kind = unread_archive(has_file)) refuse_kind(file, *kind);
  if (const char* driver = spreadsheet_of(names)) return sheet_opening(file, name, driver);
  const std::string member = data_set_in_archive(file, names);
  const InputFormat& format = *format_by_extension(member);
  return {format.drivers, "/vsizip/{" + name + "}/" + member, Opening::Packing::archived};
}

/// Opens a gzip: a CSV whose name says so, or one whose name says nothing.
Opening gzip_opening(const std::string& file, const std::string& name) {
  const bool says_so = lower_case(file).ends_with(".gz");
  const InputFormat* format = format_by_extension(says_so ? file.substr(0, file.size() - 3) : file);
  if (format != nullptr && !format->drivers.empty()) {
    refuse(file, "is a gzip archive of no CSV", "unpack it first, or read it as /vsigzip/" + file);
  }
  return {{}, name, Opening::Packing::gzip};
}

bool is_text(std::string_view bytes) {
  constexpr std::array<std::string_view, 2> utf16_marks = {"\xff\xfe", "\xfe\xff"};
  return bytes.find('\0') == std::string_view::npos ||
         std::ranges::any_of(utf16_marks,
                             [&](std::string_view mark) { return bytes.starts_with(mark); });
}

/// Refuses a page that has the name of a spreadsheet, as web sites give it to their tables.
void require_no_page(const std::string& file, std::string_view bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (begin == std::string_view::npos || bytes[begin] != '<') return;
  refuse(file, "is a page (HTML or XML) under the name of a spreadsheet",
         "open it in a spreadsheet program, and save it as .xlsx or .csv");
}

/// Opens what is called a spreadsheet, by what it is: agencies give that name to texts with tabs,
/// too, and .xls to a .xlsx.
Opening spreadsheet_opening(const std::string& file, const std::string& name,
                            std::string_view bytes, const InputFormat& format) {
  if (is_zip(bytes) && format.extension == ".xls") return zip_opening(file, name);
  if (is_zip(bytes)) return sheet_opening(file, name, format.drivers.front());
  if (!is_text(bytes)) return {format.drivers, name};
  return {{}, name};
}

void require_no_geodatabase(const std::string& file) {
  struct stat status {};
  if (lower_case(file).ends_with(".gdb") && stat(file.c_str(), &status) == 0 &&
      S_ISDIR(status.st_mode)) {
    refuse(file, "is a file geodatabase (.gdb), which is not read",
           "ogr2ogr out.gpkg FILE makes a GeoPackage of it");
  }
}

/// Opens a file that is on the disk.
Opening file_opening(const std::string& file, const std::string& name) {
  const std::string bytes = first_bytes(file, name);
  const InputFormat* format = format_by_extension(file);
  const bool is_sheet = format != nullptr && is_spreadsheet(*format);
  if (is_sheet) require_no_page(file, bytes);
  const bool is_kml = format != nullptr && format->extension == ".kml";
  if (const auto kind = unread_kind(bytes); kind && !is_kml) refuse_kind(file, *kind);
  if (is_sheet) return spreadsheet_opening(file, name, bytes, *format);
  if (format != nullptr && !format->drivers.empty()) return {format->drivers, name};
  if (is_gzip(bytes)) return gzip_opening(file, name);
  if (is_zip(bytes)) return zip_opening(file, name);
  const bool is_binary = bytes.find('\0') != std::string::npos;
  std::vector<const char*> drivers;
  if (format == nullptr || is_binary) drivers = by_first_bytes(name);
  if (format != nullptr && !drivers.empty()) {
    refuse(file,
           "is a file of the kind " + std::string(drivers.front()) + " under the name of a CSV",
           "rename it");
  }
  if (format != nullptr) return {{}, name};
  if (drivers.empty() && bytes.starts_with("SQLite format 3"))
    refuse(file, "is a SQLite database, and no GeoPackage", "export its table as .csv or .gpkg");
  return {drivers, name};
}

}  // namespace

Opening find_opening(const std::string& file) {
  start_gdal();
  if (file.starts_with("PG:")) return {{"PostgreSQL"}, file};
  if (file.starts_with("/vsi")) {
    require_local_archive(file);
    const InputFormat* format = format_by_extension(file);
    std::vector<const char*> drivers = format != nullptr ? format->drivers : by_first_bytes(file);
    return {std::move(drivers), file, Opening::Packing::archived};
  }
  require_no_geodatabase(file);
  require_readable(file);
  if (!regular(file)) return {{}, file};
  return file_opening(file, file.starts_with('/') ? file : "./" + file);
}

std::vector<std::string> tables_in_zip(const std::string& file) {
  start_gdal();
  const InputFormat* format = format_by_extension(file);
  if (!regular(file) || (format != nullptr && !format->drivers.empty())) return {};
  const std::string name = file.starts_with('/') ? file : "./" + file;
  if (!is_zip(first_bytes(file, name))) return {};
  const std::vector<std::string> names = files_in_archive(file, name);
  const auto has_file = [&](std::string_view wanted) { return has(names, wanted); };
  if (unread_archive(has_file) || spreadsheet_of(names) != nullptr) return {};
  return tables_in_archive(names);
}

bool read_by_gdal(const std::string& file) {
  return !find_opening(file).drivers.empty();
}

}  // namespace thiessen

#include "text/file_kind.h"

#include <algorithm>
#include <array>

#include "base/utf8.h"

namespace thiessen {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view of_pictures = "a picture holds no numbers: find the data it was made of";
constexpr std::string_view of_rasters =
    "stations, basins and readings are vectors and tables, not grids";
constexpr std::string_view of_grids = "export the readings at the gauges as a table, such as .csv";
constexpr std::string_view of_documents = "save its table as .csv or .xlsx";
constexpr std::string_view of_archives =
    "unpack it first; only .zip and .csv.gz open by themselves";
constexpr std::string_view of_vectors = "ogr2ogr out.gpkg FILE makes a GeoPackage of it";
constexpr std::string_view of_tables = "export its table as .csv";

struct Signature {
  std::size_t place;
  std::string_view bytes;
  FileKind kind;
};

constexpr std::array signatures = {
    Signature{0, "\x89PNG\r\n\x1a\n"sv, {"a picture (PNG)", of_pictures}},
    Signature{0, "\xff\xd8\xff"sv, {"a picture (JPEG)", of_pictures}},
    Signature{0, "GIF8"sv, {"a picture (GIF)", of_pictures}},
    Signature{0, "II*\0"sv, {"a TIFF", of_rasters}},
    Signature{0, "MM\0*"sv, {"a TIFF", of_rasters}},
    Signature{0, "II+\0"sv, {"a TIFF", of_rasters}},
    Signature{0, "MM\0+"sv, {"a TIFF", of_rasters}},
    Signature{0, "%PDF-"sv, {"a PDF document", of_documents}},
    Signature{0, "{\\rtf"sv, {"a text document (RTF)", of_documents}},
    Signature{0, "%!PS"sv, {"a PostScript document", of_documents}},
    Signature{0, "CDF\1"sv, {"a NetCDF", of_grids}},
    Signature{0, "CDF\2"sv, {"a NetCDF", of_grids}},
    Signature{0, "CDF\5"sv, {"a NetCDF", of_grids}},
    Signature{0, "\x89HDF\r\n\x1a\n"sv, {"a NetCDF-4 or HDF5", of_grids}},
    Signature{0, "\x0e\x03\x13\x01"sv, {"an HDF4", of_grids}},
    Signature{0, "GRIB\0"sv, {"a GRIB", of_grids}},
    Signature{0, "ZDSS"sv, {"a HEC-DSS", "export its series as .csv"}},
    Signature{0, "PAR1"sv, {"a Parquet table", of_tables}},
    Signature{0, "ARROW1"sv, {"an Arrow table", of_tables}},
    Signature{4, "Standard Jet DB"sv, {"an Access database", of_tables}},
    Signature{4, "Standard ACE DB"sv, {"an Access database", of_tables}},
    Signature{0, "RDX2\n"sv, {"data of R", of_tables}},
    Signature{0, "RDX3\n"sv, {"data of R", of_tables}},
    Signature{0, "MATLAB 5.0"sv, {"data of MATLAB", of_tables}},
    Signature{0, "AC10"sv, {"a drawing (DWG)", of_vectors}},
    Signature{0, "!table"sv, {"a MapInfo .tab", of_vectors}},
    Signature{4, "1AY&SY"sv, {"a bzip2 archive", of_archives}},
    Signature{0,
              "\xfd"
              "7zXZ\0"sv,
              {"an xz archive", of_archives}},
    Signature{0, "7z\xbc\xaf\x27\x1c"sv, {"a 7-Zip archive", of_archives}},
    Signature{0, "Rar!\x1a\x07"sv, {"a RAR archive", of_archives}},
    Signature{0, "\x28\xb5\x2f\xfd"sv, {"a Zstandard archive", of_archives}},
    Signature{257, "ustar"sv, {"a tar archive", of_archives}},
    Signature{0,
              "\x7f"
              "ELF"sv,
              {"a program", {}}}};

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// What an XML is by its first elements.
std::optional<FileKind> xml_kind(std::string_view text) {
  if (holds(text, "<kml") || holds(text, "/kml/2.")) return std::nullopt;
  if (holds(text, "<!doctype html") || holds(text, "<html"))
    return FileKind{"a web page (HTML)", "download the data themselves, not the page about them"};
  if (holds(text, "opengis.net/gml") || holds(text, "<gml:")) return FileKind{"a GML", of_vectors};
  if (holds(text, "<gpx")) return FileKind{"a GPX", of_vectors};
  if (holds(text, "<svg")) return FileKind{"a picture (SVG)", of_pictures};
  if (holds(text, "opengis.net/waterml") || holds(text, "<wml2:"))
    return FileKind{"a WaterML", of_tables};
  if (holds(text, "wldelft.nl/fews")) return FileKind{"a PI-XML", of_tables};
  if (text.starts_with("<?xml")) return FileKind{"an XML, and no KML", {}};
  return std::nullopt;
}

std::optional<FileKind> text_kind(std::string_view text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with('<')) return xml_kind(lower_case(std::string(text)));
  const std::string begin = lower_case(std::string(text.substr(0, 2000)));
  if (begin.starts_with("version ") && holds(begin, "\ncharset "))
    return FileKind{"a MapInfo .mif", of_vectors};
  return std::nullopt;
}

}  // namespace

std::optional<FileKind> unread_kind(std::string_view first_bytes) {
  for (const Signature& signature : signatures) {
    if (first_bytes.size() > signature.place &&
        first_bytes.substr(signature.place).starts_with(signature.bytes)) {
      return signature.kind;
    }
  }
  return text_kind(first_bytes);
}

}  // namespace thiessen

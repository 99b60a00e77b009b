#include "gdal/output/layer_formats.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"

namespace thiessen {
namespace {

struct Format {
  std::string_view extension;
  const char* driver;
  void (*register_driver)();
};

constexpr std::array formats = {Format{"gpkg", "GPKG", RegisterOGRGeoPackage},
                                Format{"shp", "ESRI Shapefile", RegisterOGRShape},
                                Format{"shz", "ESRI Shapefile", RegisterOGRShape},
                                Format{"fgb", "FlatGeobuf", RegisterOGRFlatGeobuf},
                                Format{"kml", "LIBKML", RegisterOGRLIBKML},
                                Format{"kmz", "LIBKML", RegisterOGRLIBKML},
                                Format{"gml", "GML", RegisterOGRGML},
                                Format{"tab", "MapInfo File", RegisterOGRTAB},
                                Format{"mif", "MapInfo File", RegisterOGRTAB},
                                Format{"sqlite", "SQLite", RegisterOGRSQLite},
                                Format{"csv", "CSV", RegisterOGRCSV},
                                Format{"geojsonl", "GeoJSONSeq", RegisterOGRGeoJSONSeq},
                                Format{"gmt", "OGR_GMT", RegisterOGRGMT},
                                Format{"jml", "JML", RegisterOGRJML},
                                Format{"sql", "PGDUMP", RegisterOGRPGDump}};

bool writes(GDALDriver& driver, const std::string& extension) {
  const auto is_set = [&](const char* key) { return driver.GetMetadataItem(key) != nullptr; };
  if (!is_set(GDAL_DCAP_VECTOR) || !is_set(GDAL_DCAP_CREATE) || !is_set(GDAL_DCAP_VIRTUALIO))
    return false;
  // Spreadsheets hold no geometry.
  const std::string_view name = driver.GetDescription();
  if (name == "XLSX" || name == "ODS" || is_remote_driver(name)) return false;
  const char* known = driver.GetMetadataItem(GDAL_DMD_EXTENSIONS);
  const CPLStringList extensions(CSLTokenizeString2(known == nullptr ? "" : known, " ", 0));
  return extensions.FindString(extension.c_str()) >= 0;
}

GDALDriver* find_driver(const std::string& extension) {
  start_gdal();
  const GdalErrors errors;
  GDALDriverManager& drivers = *GetGDALDriverManager();
  for (const Format& format : formats) {
    if (format.extension != extension) continue;
    format.register_driver();
    return drivers.GetDriverByName(format.driver);
  }
  register_local_drivers();
  for (int i = 0; i < drivers.GetDriverCount(); ++i) {
    if (!extension.empty() && writes(*drivers.GetDriver(i), extension)) return drivers.GetDriver(i);
  }
  return nullptr;
}

std::string known_extensions() {
  std::string text = ".geojson, .json";
  for (const Format& format : formats) text += ", ." + std::string(format.extension);
  return text;
}

[[noreturn]] void refuse(const std::string& path, const std::string& text) {
  throw Error(Message{path, 0, text, "cells are written to " + known_extensions()});
}

}  // namespace

std::string extension_of(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  return dot == std::string::npos || path[dot] == '/' ? "" : lower_case(path.substr(dot + 1));
}

bool holds_degrees_only(const std::string& extension) {
  constexpr std::array<std::string_view, 3> formats_of_degrees = {"kml", "kmz", "geojsonl"};
  return std::find(formats_of_degrees.begin(), formats_of_degrees.end(), extension) !=
         formats_of_degrees.end();
}

void require_known_degrees(const std::string& path, bool has_crs) {
  if (has_crs || !holds_degrees_only(extension_of(path))) return;
  throw Error(Message{path, 0,
                      "the format holds longitude and latitude, and the coordinates' CRS is not "
                      "known",
                      "name it with " + setting("crs")});
}

GDALDriver& require_vector_driver(const std::string& path) {
  const std::string extension = extension_of(path);
  if (extension.empty()) refuse(path, "the extension tells the format, and there is none");
  GDALDriver* driver = find_driver(extension);
  if (driver == nullptr)
    refuse(path, "no vector format has the extension ." + printable(extension));
  return *driver;
}

}  // namespace thiessen

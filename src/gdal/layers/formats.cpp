#include "gdal/layers/formats.h"

#include "base/utf8.h"

namespace thiessen {
namespace {

const std::vector<InputFormat>& formats() {
  static const std::vector<InputFormat> known = {{".geojson", {"GeoJSON"}},
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

}  // namespace

const InputFormat* format_by_extension(const std::string& file) {
  const std::string name = lower_case(file);
  const InputFormat* found = nullptr;
  for (const InputFormat& format : formats()) {
    if (name.ends_with(format.extension) &&
        (found == nullptr || format.extension.size() > found->extension.size())) {
      found = &format;
    }
  }
  return found;
}

bool is_spreadsheet(const InputFormat& format) {
  if (format.drivers.empty()) return false;
  const std::string_view driver = format.drivers.front();
  return driver == "XLSX" || driver == "ODS" || driver == "XLS";
}

}  // namespace thiessen

#include "gdal/layers/wholeness.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "base/error.h"
#include "base/utf8.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/byte_order.h"
#include "gdal/layers/flatgeobuf_length.h"
#include "gdal/layers/shapefile_parts.h"
#include "gdal/layers/vsi_bytes.h"

namespace thiessen {
namespace {

/// Requires a GeoPackage to be as long as the header of its SQLite database says.
void require_whole_geopackage(const std::string& file, const std::string& name) {
  constexpr std::size_t header_bytes = 100;
  VsiBytes bytes(file, name);
  const std::string header = bytes.read_at(0, header_bytes);
  if (header.size() < header_bytes || !header.starts_with("SQLite format 3")) return;
  const auto number = [&](std::size_t place, std::size_t count) {
    return big_endian(std::string_view(header).substr(place, count));
  };
  const std::uint64_t page = number(16, 2) == 1 ? 65536 : number(16, 2);
  const std::uint64_t pages = number(28, 4);
  // Programs older than SQLite 3.7 do not keep the number of pages: the two counters tell.
  const bool is_kept = number(24, 4) == number(92, 4);
  // Pages that stand in a log beside the file are not missing.
  if (!is_kept || vsi_exists(name + "-wal") || bytes.size() >= page * pages) return;
  throw Error(Message{file, 0,
                      "is cut off: it has " + std::to_string(bytes.size()) +
                          " bytes, and its header declares " + std::to_string(page * pages),
                      "a copy or a download was cut off: get it anew"});
}

/// The shapefiles in an archive that GDAL opens as one dataset.
std::vector<std::string> shapefiles_in(const std::string& archive) {
  const std::string folder = "/vsizip/{" + archive + "}";
  const GdalErrors errors;
  const CPLStringList names(VSIReadDirRecursive(folder.c_str()));
  std::vector<std::string> found;
  for (int i = 0; i < names.Count(); ++i) {
    if (lower_case(names[i]).ends_with(".shp")) found.push_back(folder + "/" + names[i]);
  }
  return found;
}

}  // namespace

void require_whole(const std::string& file, const Opening& opening,
                   std::vector<std::string>& oddities) {
  const std::string_view driver = opening.drivers.front();
  if (driver == "FlatGeobuf") require_whole_flatgeobuf(file, opening.name);
  if (driver == "GPKG") require_whole_geopackage(file, opening.name);
  if (driver != "ESRI Shapefile") return;
  const std::string name = lower_case(opening.name);
  if (name.ends_with(".shp") || name.ends_with(".dbf")) {
    require_whole_shapefile(file, opening.name, oddities);
  } else {
    for (const std::string& shapefile : shapefiles_in(opening.name))
      require_whole_shapefile(file, shapefile, oddities);
  }
}

std::optional<std::uint64_t> declared_features(OGRLayer& layer, const Opening& opening) {
  constexpr std::array<std::string_view, 4> untold = {"ESRI Shapefile", "LIBKML", "KML",
                                                      "PostgreSQL"};
  if (std::find(untold.begin(), untold.end(), opening.drivers.front()) != untold.end())
    return std::nullopt;
  const GIntBig count = layer.GetFeatureCount(TRUE);
  if (count < 0) return std::nullopt;
  return static_cast<std::uint64_t>(count);
}

}  // namespace thiessen

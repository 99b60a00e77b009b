#include "gdal/output/written_validity.h"

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string_view>

#include "gdal/drivers.h"
#include "gdal/gdal_errors.h"
#include "gdal/layers/geometry_conversion.h"
#include "outlines/polygon_validity.h"

namespace thiessen {
namespace {

constexpr std::array<std::string_view, 5> keep_doubles = {"GPKG", "ESRI Shapefile", "FlatGeobuf",
                                                          "SQLite", "PGDUMP"};

std::unique_ptr<GDALDataset> open(const std::string& file, const std::string& driver) {
  start_gdal();
  const GdalErrors errors;
  // What was just written has its driver; of any other file any may be wanted.
  if (GetGDALDriverManager()->GetDriverByName(driver.c_str()) == nullptr) register_local_drivers();
  CPLStringList drivers;
  drivers.AddString(driver.c_str());
  CPLStringList options;
  if (driver == "CSV") options.SetNameValue("GEOM_POSSIBLE_NAMES", "WKT");
  return std::unique_ptr<GDALDataset>(GDALDataset::Open(
      file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers.List(), options.List()));
}

}  // namespace

std::optional<WrittenFault> fault_after_rounding(const std::string& file,
                                                 const std::string& driver) {
  if (std::find(keep_doubles.begin(), keep_doubles.end(), driver) != keep_doubles.end())
    return std::nullopt;
  const std::unique_ptr<GDALDataset> dataset = open(file, driver);
  if (dataset == nullptr || dataset->GetLayerCount() == 0) return std::nullopt;
  const GdalErrors errors;
  OGRLayer& layer = *dataset->GetLayer(0);
  std::size_t number = 0;
  for (const auto& feature : layer) {
    const OGRGeometry* geometry = feature->GetGeometryRef();
    const std::string reason = geometry == nullptr ? "" : validity_fault(polygons_of(*geometry));
    if (!reason.empty()) return WrittenFault{number, reason};
    ++number;
  }
  return std::nullopt;
}

}  // namespace thiessen

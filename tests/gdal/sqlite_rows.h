#pragma once

#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/temporary_folder.h"
#include "gdal/drivers.h"

namespace thiessen {

/// The rows that a query finds in the bytes of a GeoPackage, each as its values with `|` between
/// them; a shape as WKT at the end, where there is one.
inline std::vector<std::string> sqlite_rows(const std::string& geopackage,
                                            const std::string& query) {
  start_gdal();
  const TemporaryFolder folder;
  const std::string file = folder.write("rows.gpkg", geopackage);
  const std::array<const char*, 2> drivers{"GPKG", nullptr};
  const std::unique_ptr<GDALDataset> dataset(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR, drivers.data(), nullptr, nullptr));
  if (dataset == nullptr) return {"no GeoPackage"};
  OGRLayer* const found = dataset->ExecuteSQL(query.c_str(), nullptr, nullptr);
  if (found == nullptr) return {"no answer"};
  std::vector<std::string> rows;
  for (const auto& feature : *found) {
    std::string row;
    for (int i = 0; i < feature->GetFieldCount(); ++i) {
      if (i > 0) row += '|';
      row += feature->IsFieldSetAndNotNull(i) ? feature->GetFieldAsString(i) : "-";
    }
    if (const OGRGeometry* const shape = feature->GetGeometryRef())
      row += '|' + shape->exportToWkt();
    rows.push_back(row);
  }
  dataset->ReleaseResultSet(found);
  return rows;
}

}  // namespace thiessen

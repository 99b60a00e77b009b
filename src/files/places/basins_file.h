#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/error.h"
#include "files/places/crs_origin.h"
#include "files/tables/source.h"
#include "gdal/crs/crs.h"
#include "study/source_lists.h"

namespace thiessen {

/// A file of basins to be read, and the field of their ids.
struct BasinsRequest {
  Source source;
  std::string id;  ///< name of the field of ids; empty: found by the usual names and by its values
  std::string normal_field;                    ///< see StationsRequest
  std::optional<std::string> elevation_field;  ///< of mean elevations; see StationsRequest
};

/// The basins of a file, in its coordinates, with the CRS that they are known to have.
struct BasinsFile : BasinList {
  std::optional<Crs> crs;
  CrsOrigin crs_origin = CrsOrigin::none;
  /// The normals of the basins, by their ids: see StationsFile.
  std::unordered_map<std::string, std::vector<double>> normals;
  /// The elevations of the basins, by their ids: see StationsFile.
  std::unordered_map<std::string, double> elevations;
};

/// Reads the basins: polygons of any vector file that GDAL reads, or of the column named WKT of a
/// CSV. Throws Error with every bad feature (no geometry, a geometry that is no polygon, a
/// coordinate that is no finite number), and where there are no basins. Cost: linear in the file's
/// length.
BasinsFile read_basins(const BasinsRequest& request, Warnings& warnings);

}  // namespace thiessen

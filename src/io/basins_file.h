#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/polygon.h"
#include "io/crs.h"
#include "io/crs_origin.h"
#include "io/source.h"

namespace thiessen {

struct BasinsRequest {
  Source source;
  std::string id;  ///< the field's name (--basin-id); empty: found by the contract's rule
};

/// A basin as its file has it: the polygons of all features that share its id, not yet mended.
struct RawBasin {
  std::string id;
  std::string place;      ///< `basin 'X' (features[2].geometry)`, for messages
  std::size_t line = 0;   ///< in a CSV, of its first feature; else 0
  MultiPolygon polygons;  ///< rings as in the file: any direction, last point repeated
};

struct BasinsFile {
  std::string file;
  std::vector<RawBasin> basins;  ///< in the order in which their ids first come
  std::optional<Crs> crs;
  CrsOrigin crs_origin = CrsOrigin::none;
};

/// Reads the basins: polygons of any vector file that GDAL reads, or of a CSV's column named WKT.
/// Throws Error with every bad feature: no geometry, no polygon, a coordinate that is no finite
/// number; and where there are no basins. Cost: linear in the file's length.
BasinsFile read_basins(const BasinsRequest& request, Warnings& warnings);

}  // namespace thiessen

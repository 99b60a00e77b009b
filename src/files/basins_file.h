#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "files/crs_origin.h"
#include "files/source.h"
#include "gdal/crs.h"
#include "study/source_lists.h"

namespace thiessen {

struct BasinsRequest {
  Source source;
  std::string id;  ///< the field's name; empty: found by the contract's rule
};

struct BasinsFile : BasinList {
  std::optional<Crs> crs;
  CrsOrigin crs_origin = CrsOrigin::none;
};

/// Reads the basins: polygons of any vector file that GDAL reads, or of a CSV's column named WKT.
/// Throws Error with every bad feature: no geometry, no polygon, a coordinate that is no finite
/// number; and where there are no basins. Cost: linear in the file's length.
BasinsFile read_basins(const BasinsRequest& request, Warnings& warnings);

}  // namespace thiessen

#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gdal/crs/crs.h"

namespace thiessen {

/// What a grid in NetCDF says of its CRS, by the conventions CF-1.8 (appendix F).
struct GridMapping {
  /// `crs_wkt`, and `grid_mapping_name` where CF has the projection.
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::pair<std::string, std::vector<double>>> numbers;
  /// The unit of eastings and northings as UDUNITS knows it (`m`); empty for a geographic CRS.
  std::string unit;
};

GridMapping grid_mapping(const Crs& crs);

}  // namespace thiessen

#pragma once

#include <ogr_spatialref.h>

#include <optional>
#include <string>

#include "gdal/crs/crs.h"

namespace thiessen {

/// The definition that all copies of a Crs share.
struct Crs::Definition {
  OGRSpatialReference system;  ///< traditional axis order, two dimensions
  std::string wkt;
  std::string name;
  bool geographic = false;
  bool is_wgs84 = false;
  double unit = 0;  ///< degrees or metres in one unit
};

/// The CRS that a file names; empty where it is a plane of its own (engineering, "undefined").
/// Throws Error, naming `file`, where it is not of the Earth, or neither geographic nor projected.
std::optional<Crs> crs_from_system(const OGRSpatialReference& system, const std::string& file);

}  // namespace thiessen

#pragma once

#include <string>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// A feature's geometry as its file has it, before any check. Rings keep the file's order of
/// points, its direction and its repeated last point.
struct GeometryRecord {
  std::string type;  ///< `Point`, `MultiPolygon` ...; empty where the feature has none
  bool has_z = false;
  std::vector<Point> points;  ///< of a Point or MultiPoint
  MultiPolygon polygons;      ///< of a Polygon or MultiPolygon
};

}  // namespace thiessen

#pragma once

#include <cstddef>
#include <string>

#include "geometry/polygon.h"

namespace thiessen {

/// A basin as its file has it: the polygons of all features that share its id, not yet mended.
struct RawBasin {
  std::string id;
  std::string place;      ///< `basin 'X' (features[2].geometry)`, for messages
  std::size_t line = 0;   ///< line of its first feature in a CSV; else 0
  MultiPolygon polygons;  ///< rings as in the file: any direction, last point repeated
};

}  // namespace thiessen

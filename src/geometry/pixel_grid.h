#pragma once

#include "geometry/point.h"

namespace thiessen {

/// Where a raster's pixels lie: row 0 is the northern one.
struct PixelGrid {
  Point north_west;  ///< the outer corner of the first pixel
  double pixel = 0;  ///< its side, in the unit of the coordinates
  int columns = 0;
  int rows = 0;

  Point centre(int column, int row) const {
    return {north_west.x + (column + 0.5) * pixel, north_west.y - (row + 0.5) * pixel};
  }
};

}  // namespace thiessen

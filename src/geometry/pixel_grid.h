#pragma once

#include "geometry/point.h"

namespace thiessen {

/// Where a raster's pixels lie: row 0 is the northern one.
struct PixelGrid {
  Point north_west;  ///< the outer corner of the first pixel
  double pixel = 0;  ///< its side, in the unit of the coordinates
  int columns = 0;
  int rows = 0;

  /// So many pixels east and south of the outer corner.
  Point at(double columns_east, double rows_south) const {
    return {north_west.x + columns_east * pixel, north_west.y - rows_south * pixel};
  }
  Point centre(int column, int row) const { return at(column + 0.5, row + 0.5); }
};

/// A rectangle of a raster's pixels.
struct PixelBlock {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;

  bool is_pixel() const { return columns == 1 && rows == 1; }
};

}  // namespace thiessen

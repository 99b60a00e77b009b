#pragma once

#include "geometry/point.h"

namespace thiessen {

/// A rectangle of a raster's pixels, from its first column and row on.
struct PixelBlock {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;

  bool is_pixel() const { return columns == 1 && rows == 1; }
};

/// The georeference of a raster: where its pixels lie. Row 0 is the northern one.
struct PixelGrid {
  Point north_west;  ///< the outer corner of the first pixel, or of the raster that it is a part of
  double pixel = 0;  ///< the side of a pixel, in the unit of the coordinates
  int columns = 0;
  int rows = 0;
  /// The column and the row of a whole raster at which this part of it begins.
  int first_column = 0;
  int first_row = 0;

  /// The point that lies so many pixels east and south of the first pixel's outer corner.
  Point at(double columns_east, double rows_south) const {
    return {north_west.x + (first_column + columns_east) * pixel,
            north_west.y - (first_row + rows_south) * pixel};
  }
  Point centre(int column, int row) const { return at(column + 0.5, row + 0.5); }

  /// A part of the raster as a raster of its own, whose pixels have the same centres to the bit.
  PixelGrid part(const PixelBlock& block) const {
    return {north_west,           pixel, block.columns, block.rows, first_column + block.column,
            first_row + block.row};
  }
};

}  // namespace thiessen

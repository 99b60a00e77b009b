#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Which pixels' centres lie in one of some areas (see OwnerRaster), a band of rows at a time.
class AreaRows {
 public:
  /// `areas`: in the raster's coordinates. Memory: 16 bytes a vertex.
  AreaRows(const PixelGrid& grid, const std::vector<MultiPolygon>& areas);

  /// Of so many rows from `row` on, row by row from the north: `inside` in an area, 0 elsewhere.
  /// Cost: the pixels, and the vertices of rings that reach into the rows. Stops with Interrupted
  /// where a signal came.
  std::vector<std::int32_t> rows(int row, int count, std::int32_t inside) const;

 private:
  /// In pixels from the raster's corner.
  struct PixelRing {
    Ring ring;
    double north;
    double south;
  };

  int columns_;
  std::vector<std::vector<PixelRing>> areas_;
};

}  // namespace thiessen

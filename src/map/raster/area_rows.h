#pragma once

#include <cstdint>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Tells which pixels have their centre in one of some areas (see OwnerRaster), a band of rows at a
/// time.
class AreaRows {
 public:
  /// `areas` are in the raster's coordinates. Memory: 16 bytes a vertex.
  AreaRows(const PixelGrid& grid, const std::vector<MultiPolygon>& areas);

  /// The pixels of `count` rows from `row` on, row by row from the north: `inside` for a pixel in
  /// an area, else 0. Cost: the pixels, and the vertices of rings that reach into the rows. Stops
  /// with Interrupted where a signal came.
  std::vector<std::int32_t> rows(int row, int count, std::int32_t inside) const;

 private:
  /// A ring in pixels from the raster's corner, and the rows between which it lies.
  struct PixelRing {
    Ring ring;
    double north;
    double south;
  };

  int columns_;
  std::vector<std::vector<PixelRing>> areas_;
};

}  // namespace thiessen

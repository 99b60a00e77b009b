#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygon.h"

namespace thiessen {

/// Tells which shape each pixel of a raster belongs to: the last one filled that holds the pixel's
/// centre.
///
/// Rows run downward with y; pixel (column, row) has its centre at (column + 0.5, row + 0.5). A
/// centre lies in a shape if an odd number of the shape's edges cross the row at or to the left of
/// it. An edge crosses the rows from its upper end, included, to its lower end, excluded, and the
/// crossings do not depend on the edge's direction. Hence shapes that share their edges vertex for
/// vertex neither overlap nor leave a gap.
class OwnerRaster {
 public:
  static constexpr std::int32_t nobody = -1;

  /// `before` is the owner of pixels that belong to no shape.
  OwnerRaster(int width, int height, std::int32_t before = nobody);

  int width() const { return width_; }
  int height() const { return height_; }
  std::int32_t at(int column, int row) const { return owners_[offset(column, row)]; }
  /// The owner of each pixel, row by row from the top.
  std::span<const std::int32_t> owners() const { return owners_; }
  std::span<std::int32_t> owners() { return owners_; }

  /// Gives `owner` the pixels inside `rings`, which are in pixels, by the even-odd rule; parts
  /// outside the raster are left out. Coordinates must be finite. Cost: the rings' vertices, the
  /// pixel rows that their edges cross, and the pixels filled. Stops with Interrupted where a
  /// signal came.
  void fill(std::span<const Ring> rings, std::int32_t owner);

 private:
  /// The first and the last word of a row of `odd_` that hold crossings.
  struct Touched {
    std::size_t first;
    std::size_t last;
  };

  std::size_t offset(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }
  void cross(Point a, Point b);
  void toggle(int column, int row);
  void fill_row(int row, std::int32_t owner);

  int width_;
  int height_;
  std::size_t words_;  ///< words in a row of `odd_`
  int top_ = 0;        ///< first and last row that hold crossings
  int bottom_ = -1;
  std::vector<std::int32_t> owners_;
  std::vector<std::uint64_t> odd_;  ///< a bit a pixel: set where an odd number of crossings begins
  std::vector<Touched> touched_;    ///< for each row
};

}  // namespace thiessen

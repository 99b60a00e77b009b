#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/pixel_grid.h"
#include "geometry/polygon.h"

namespace thiessen {

/// Pixels of one row, from column `first` to the one before `end`.
struct PixelSpan {
  int first;
  int end;
};

/// The pixels of some rows that have their centre in an area.
class AreaSpans {
 public:
  /// The row's pixels from the west, in spans that do not touch; rows count from the first of them.
  std::span<const PixelSpan> row(int row) const {
    const auto i = static_cast<std::size_t>(row);
    return std::span(spans_).subspan(begins_[i], begins_[i + 1] - begins_[i]);
  }

 private:
  friend class AreaRows;
  std::vector<PixelSpan> spans_;
  std::vector<std::size_t> begins_{0};
};

/// Tells which pixels have their centre in one of some areas, by the even-odd rule, a band of rows
/// at a time.
///
/// A centre lies in an area if an odd number of the area's edges cross the row at or to the left of
/// it. An edge crosses the rows from its upper end, included, to its lower end, excluded, and the
/// crossings do not depend on the edge's direction. Hence areas that share their edges vertex for
/// vertex neither overlap nor leave a gap.
class AreaRows {
 public:
  /// `areas` are in the raster's coordinates. Memory: 16 bytes a vertex.
  AreaRows(const PixelGrid& grid, const std::vector<MultiPolygon>& areas);

  /// The pixels of `count` rows from `row` on. Cost: the vertices of rings that reach into the
  /// rows, and the rows that their edges cross. Stops with Interrupted where a signal came.
  AreaSpans rows(int row, int count) const;

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

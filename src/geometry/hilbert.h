#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry/box.h"
#include "geometry/coordinates.h"
#include "geometry/hilbert_steps.h"
#include "geometry/point.h"

namespace thiessen {

/// Hilbert's curve through a grid of square (in space cubic) cells over a box: cells that follow
/// each other on the curve share a side. The curve starts in the box's low corner and ends where x
/// is largest.
template <int Dimension>
class HilbertGrid {
 public:
  using Coordinates = CoordinatesIn<Dimension>;

  /// The number of levels: the box's longest side has 2^levels cells.
  static constexpr int levels = Dimension == 2 ? 16 : 10;
  static constexpr int distance_bits = Dimension * levels;

  /// Lays the grid over the box with these corners. Requires low <= high in each coordinate.
  HilbertGrid(const Coordinates& low, const Coordinates& high) : low_(low) {
    double longest = 0;
    for (std::size_t axis = 0; axis < low.size(); ++axis) {
      longest = std::max(longest, high[axis] - low[axis]);
    }
    const double scale = side / longest;
    if (std::isfinite(scale)) scale_ = scale;
  }

  /// Whether the two ends of the box lie in different cells, however few bits of the distance are
  /// looked at. They do not if the box is a point, or nearly one (1e-303), or longer than a double
  /// can say.
  bool divides() const { return scale_ > 0; }

  /// How far along the curve the point's cell lies, in cells. The leading bits alone are the
  /// distance in a coarser grid. Requires a point of the box.
  std::uint32_t distance(const PositionIn<Dimension>& p) const {
    const Coordinates c = coordinates(p);
    CoordinatesIn<Dimension, std::uint32_t> cell;
    for (std::size_t axis = 0; axis < cell.size(); ++axis) {
      const double steps = (c[axis] - low_[axis]) * scale_;
      const double within = steps < side - 1 ? steps : side - 1;  // also caps a NaN
      cell[axis] = static_cast<std::uint32_t>(static_cast<std::int32_t>(within));
    }
    return hilbert::along_curve<Dimension, levels>(cell);
  }

 private:
  static constexpr double side = 1 << levels;

  Coordinates low_;
  double scale_ = 0;  // cells for each unit of length
};

/// How far along Hilbert's curve through `box` the point lies, in steps of a grid that has 65536
/// cells along the longer side. Points whose numbers are near are near each other. Requires a point
/// of the box.
std::uint32_t hilbert_distance(const Box& box, Point p);

}  // namespace thiessen

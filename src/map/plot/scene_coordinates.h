#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "geometry/coordinates.h"
#include "tessellation/tessellation.h"

namespace thiessen {

/// The smallest and the largest coordinates of some points, axis by axis; empty at first.
template <int Dimension>
struct CoordinateRange {
  CoordinatesIn<Dimension> low;
  CoordinatesIn<Dimension> high;

  CoordinateRange() {
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
  }
  explicit CoordinateRange(const Tessellation<Dimension>& tessellation) : CoordinateRange() {
    tessellation.for_each_point([this, &tessellation](PointId p) {
      const auto position = coordinates(tessellation.position(p));
      for (std::size_t i = 0; i < position.size(); ++i) {
        low[i] = std::min(low[i], position[i]);
        high[i] = std::max(high[i], position[i]);
      }
    });
  }

  double side(std::size_t axis) const { return high[axis] - low[axis]; }
  double longest_side() const {
    double longest = 0;
    for (std::size_t i = 0; i < low.size(); ++i) longest = std::max(longest, side(i));
    return longest;
  }
};

/// The coordinates in which a picture is composed: the middle of the points' range is 0 and its
/// longest side is 1, whatever the points' own coordinates are. A single point gets a range around
/// it.
///
/// On the way positions are shifted, axis by axis, by an origin that changes no difference in the
/// last bit (the range lies between the origin and its double, else there is no shift). So centres
/// that are computed from shifted positions keep their digits however far from 0 the points are.
template <int Dimension>
class SceneCoordinates {
 public:
  using Coordinates = CoordinatesIn<Dimension>;
  using Position = PositionIn<Dimension>;

  /// Requires a range of at least one point. `stretch` says how many times longer each axis is
  /// drawn.
  SceneCoordinates(const CoordinateRange<Dimension>& range, const Coordinates& stretch) {
    double size = range.longest_side();
    double largest = 0;
    for (std::size_t i = 0; i < origin_.size(); ++i) {
      const double low = range.low[i];
      const double high = range.high[i];
      origin_[i] = low > 0 && high <= 2 * low ? low : high < 0 && low >= 2 * high ? high : 0;
      middle_[i] = (low - origin_[i]) / 2 + (high - origin_[i]) / 2;
      largest = std::max({largest, std::abs(low), std::abs(high)});
    }
    if (!(size > 0)) size = largest > 0 ? largest / 4 : 1;
    for (std::size_t i = 0; i < origin_.size(); ++i) {
      scale_[i] = stretch[i] / size;
      half_[i] = range.side(i) / 2 * scale_[i];
    }
  }

  Position shifted(const Position& p) const {
    if constexpr (Dimension == 2) {
      return {p.x - origin_[0], p.y - origin_[1]};
    } else {
      return {p.x - origin_[0], p.y - origin_[1], p.z - origin_[2]};
    }
  }
  /// The coordinates in the scene of a shifted position.
  Coordinates placed(const Position& shifted) const {
    Coordinates c = coordinates(shifted);
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = (c[i] - middle_[i]) * scale_[i];
    return c;
  }
  Coordinates operator()(const Position& p) const { return placed(shifted(p)); }

  /// The number of units of the scene to one unit of the points' coordinates.
  double scale(std::size_t axis) const { return scale_[axis]; }
  double origin(std::size_t axis) const { return origin_[axis]; }
  /// Turns a coordinate in the scene back into the points' own, less the origin.
  double unplaced(std::size_t axis, double coordinate) const {
    return coordinate / scale_[axis] + middle_[axis];
  }
  /// Half the sides of the range, in units of the scene.
  const Coordinates& half() const { return half_; }

 private:
  Coordinates origin_;
  Coordinates middle_;
  Coordinates scale_;
  Coordinates half_;
};

}  // namespace thiessen

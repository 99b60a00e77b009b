#pragma once

#include <array>

#include "geometry/point.h"

namespace thiessen {

/// A straight way from one point to another.
struct Segment {
  Point from;
  Point to;
};

/// The point on the segment at this share of the way: 0 is `from`, 1 is `to`.
constexpr Point between(Point from, Point to, double share) {
  return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)};
}

/// A sample of Boole's rule (G. Boole), which gives the mean distance of a curve from a segment
/// that it meets at both ends: `along` is where on the segment the distance is taken, as a share of
/// its length, and `weight` is how much it counts.
struct BooleSample {
  double along;
  double weight;
};
/// The inner samples of Boole's rule; those at the ends are left out, because the curve meets the
/// segment there.
inline constexpr std::array<BooleSample, 3> boole_samples{
    {{0.25, 32. / 90}, {0.5, 12. / 90}, {0.75, 32. / 90}}};

}  // namespace thiessen

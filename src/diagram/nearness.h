#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/point.h"

namespace thiessen {

/// How near a place is to the points of a plane, or of a chart of a small part of the Earth: a
/// figure that is the less the nearer the place is. It lacks what is the same for all places, the
/// square of the point's own distance from the origin; so it is straight in a plane, and nearly so
/// in a chart.
struct Nearness {
  /// Of 1, x and y.
  std::array<double, 3> straight{};
  /// Of what a chart adds to that: x², xy, y², x³, x²y, xy², y³, x⁴, x³y, x²y², xy³ and y⁴.
  std::array<double, 12> bent{};
  /// What that adds at most, anywhere in the part that the figure is for. It is 0 in a plane.
  double most_bent = 0;

  double straight_at(Point p) const { return straight[0] + straight[1] * p.x + straight[2] * p.y; }
  double at(Point p) const { return straight_at(p) + (most_bent == 0 ? 0 : bent_at(p)); }

  double bent_at(Point p) const {
    const auto& c = bent;
    const double square = c[0] * p.x * p.x + (c[1] * p.x + c[2] * p.y) * p.y;
    const double cube =
        (c[3] * p.x + c[4] * p.y) * p.x * p.x + (c[5] * p.x + c[6] * p.y) * p.y * p.y;
    const double fourth = ((c[7] * p.x + c[8] * p.y) * p.x + c[9] * p.y * p.y) * p.x * p.x +
                          (c[10] * p.x + c[11] * p.y) * p.y * p.y * p.y;
    return square + cube + fourth;
  }

  friend Nearness operator-(const Nearness& a, const Nearness& b) {
    Nearness difference;
    for (std::size_t i = 0; i < a.straight.size(); ++i)
      difference.straight[i] = a.straight[i] - b.straight[i];
    difference.most_bent = a.most_bent + b.most_bent;
    if (difference.most_bent == 0) return difference;
    for (std::size_t i = 0; i < a.bent.size(); ++i) difference.bent[i] = a.bent[i] - b.bent[i];
    return difference;
  }
};

/// The nearness of a place of a plane, in coordinates from an origin.
inline Nearness plane_nearness(Point place, Point origin) {
  const Point way{place.x - origin.x, place.y - origin.y};
  return {{way.x * way.x + way.y * way.y, -2 * way.x, -2 * way.y}, {}, 0};
}

}  // namespace thiessen
